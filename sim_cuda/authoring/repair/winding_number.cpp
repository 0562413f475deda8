// SPDX-License-Identifier: Apache-2.0
// Median splits along the longest side; solid angles by the formula of Van Oosterom and Strackee.
#include "sim_cuda/authoring/repair/winding_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_cuda/authoring/double3.h"

namespace demolish {
namespace {

constexpr uint32_t kLeaf = 4;    // triangles
constexpr double kFarRadii = 2;  // beyond them a node is a dipole
constexpr int kDepth = 64;

Double3 middleOf(const std::array<Double3, 3>& t) {
    return (t[0] + t[1] + t[2]) * (1.0 / 3);
}

/// A sum of angles between -pi and pi, each of which a vector in the plane has: the angle of the vectors'
/// product as complex numbers, and its turns. One arc tangent serves all.
class AngleSum {
  public:
    void add(double x, double y) {
        const double real = real_ * x - imaginary_ * y, imaginary = real_ * y + imaginary_ * x;
        const double size = std::abs(real) + std::abs(imaginary);
        if (!(size > 0)) return;  // it has none
        // Two angles of one sign have gone half round when their product lies on the other side.
        turns_ += int(imaginary_ >= 0) & int(y >= 0) & int(imaginary < 0);
        turns_ -= int(imaginary_ < 0) & int(y < 0) & int(imaginary >= 0);
        const double scale = size > kLeast && size < 1 / kLeast ? 1 : 1 / size;
        real_ = real * scale;
        imaginary_ = imaginary * scale;
    }
    double sum() const { return std::atan2(imaginary_, real_) + 2 * std::numbers::pi * turns_; }

  private:
    static constexpr double kLeast = 1e-100;
    double real_ = 1, imaginary_ = 0;  // of any length between
    int turns_ = 0;
};

/// Half of what the triangle takes of the view from p.
void addHalfSolidAngle(AngleSum& sum, const std::array<Double3, 3>& triangle, const Double3& p) {
    const Double3 a = triangle[0] - p, b = triangle[1] - p, c = triangle[2] - p;
    const double la = length(a), lb = length(b), lc = length(c);
    sum.add(la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb, dot(a, cross(b, c)));
}

}  // namespace

WindingNumber::WindingNumber(const TriangleMesh& mesh, const std::vector<char>& flags) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& k = mesh.triangles[t];
        if (flags.empty() || flags[t] != 0)
            triangles_.push_back({mesh.positions[k[0]], mesh.positions[k[1]], mesh.positions[k[2]]});
    }
    if (!triangles_.empty()) build(0, uint32_t(triangles_.size()));
}

WindingNumber::WindingNumber(const std::vector<Double3>& positions, const std::vector<Triangle>& triangles) {
    for (const Triangle& k : triangles)
        triangles_.push_back({positions[k[0]], positions[k[1]], positions[k[2]]});
    if (!triangles_.empty()) build(0, uint32_t(triangles_.size()));
}

WindingNumber::Node WindingNumber::summed(uint32_t begin, uint32_t end) const {
    Node node;
    node.first = begin;
    node.count = end - begin;
    Double3 weighted, plain;
    double area = 0;
    for (uint32_t i = begin; i < end; ++i) {
        const auto& t = triangles_[i];
        const Double3 dipole = cross(t[1] - t[0], t[2] - t[0]) * 0.5, middle = middleOf(t);
        weighted += middle * length(dipole);
        plain += middle;
        area += length(dipole);
        node.dipole += dipole;
    }
    node.centre = area > 0 ? weighted * (1 / area) : plain * (1.0 / node.count);
    double squared = 0;
    for (uint32_t i = begin; i < end; ++i)
        for (const Double3& p : triangles_[i]) squared = std::max(squared, lengthSquared(p - node.centre));
    node.radius = std::sqrt(squared);
    return node;
}

uint32_t WindingNumber::build(uint32_t begin, uint32_t end) {
    const auto id = uint32_t(nodes_.size());
    nodes_.push_back(summed(begin, end));
    if (end - begin <= kLeaf) return id;
    Double3 lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
    for (uint32_t i = begin; i < end; ++i) {
        lower = minimum(lower, middleOf(triangles_[i]));
        upper = maximum(upper, middleOf(triangles_[i]));
    }
    const Double3 size = upper - lower;
    const auto along = [&](const std::array<Double3, 3>& t) {
        return size.x >= std::max(size.y, size.z) ? t[0].x + t[1].x + t[2].x
               : size.y >= size.z                 ? t[0].y + t[1].y + t[2].y
                                                  : t[0].z + t[1].z + t[2].z;
    };
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle, triangles_.begin() + end,
                     [&](const auto& a, const auto& b) { return along(a) < along(b); });
    nodes_[id].count = 0;
    build(begin, middle);
    const uint32_t right = build(middle, end);
    nodes_[id].right = right;
    return id;
}

double WindingNumber::at(const Double3& point) const {
    if (nodes_.empty()) return 0;
    std::array<uint32_t, kDepth + 1> stack;
    size_t size = 0;
    stack[size++] = 0;
    double angle = 0;
    AngleSum halves;
    while (size > 0) {
        const uint32_t id = stack[--size];
        const Node& node = nodes_[id];
        const Double3 way = node.centre - point;
        const double squared = lengthSquared(way), far = kFarRadii * node.radius;
        if (squared > far * far) {
            angle += dot(way, node.dipole) / (squared * std::sqrt(squared));
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i)
            addHalfSolidAngle(halves, triangles_[i], point);
        if (node.count > 0) continue;
        stack[size++] = node.right;
        stack[size++] = id + 1;
    }
    return (angle + 2 * halves.sum()) / (4 * std::numbers::pi);
}

}  // namespace demolish
