// SPDX-License-Identifier: Apache-2.0
// Bounding-box tree over the triangles of a mesh: the walk behind ray and nearest-point queries.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

struct TreeBox {
    Double3 lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
    void add(const Double3& p) {
        lower = minimum(lower, p);
        upper = maximum(upper, p);
    }
    void add(const TreeBox& other) {
        lower = minimum(lower, other.lower);
        upper = maximum(upper, other.upper);
    }
    /// m^2, half of the surface; 0 when nothing was added.
    double halfArea() const {
        const Double3 d = upper - lower;
        return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
    }
    /// m^2, 0 inside. Without branches: which side of a box a point is on is hard to foresee.
    double distanceSquared(const Double3& p) const {
        const auto beyond = [](double below, double above) {
            const double most = below > above ? below : above;
            return most > 0 ? most : 0;
        };
        return lengthSquared({beyond(lower.x - p.x, p.x - upper.x), beyond(lower.y - p.y, p.y - upper.y),
                              beyond(lower.z - p.z, p.z - upper.z)});
    }
};

/// Copies the corners of the triangles, so the mesh need not outlive it. Long triangles that lie askew, whose
/// boxes are mostly empty, are in several leaves, each with the box of a part of it.
class TriangleTree {
  public:
    using Corners = std::array<Double3, 3>;
    explicit TriangleTree(const TriangleMesh& mesh);

    /// May a walk visit a triangle more than once?
    bool repeats() const { return triangles_.size() > triangle_count_; }

    /// Boxes are widened by rounding, so a point outside is certainly outside the mesh.
    bool boundsContain(const Double3& p) const { return nodes_[0].box.distanceSquared(p) == 0; }

    /// Calls visit(corners, triangle) for every triangle that the half line may meet within `reach` (lengths
    /// of `direction`; the visitor may lower it), until visit returns false; then so does this.
    template <typename Visit>
    bool visitAlongRay(const Double3& origin, const Double3& direction, const double& reach,
                       Visit&& visit) const;

    /// Calls visit(corners, triangle) near ones first, for all that may be as near as `bound_squared` (m^2),
    /// which the visitor lowers as it finds nearer ones.
    template <typename Visit>
    void visitNearest(const Double3& point, const double& bound_squared, Visit&& visit) const;

  private:
    struct Node {
        TreeBox box;
        uint32_t first =
            0;  ///< leaf: first of its triangles; inner node: its second child (the first is the next node)
        uint32_t count = 0;  ///< 0: inner node
    };
    struct Builder;
    static constexpr int kMaxDepth = 64;

    std::vector<Node> nodes_;
    std::vector<Corners> corners_;     // in tree order
    std::vector<uint32_t> triangles_;  // mesh ids in tree order
    size_t triangle_count_;            // of the mesh
};

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

/// May the line from `origin` meet the box within `reach`? `inverse` is 1 / direction, no component of which
/// is 0.
inline bool rayMeetsBox(const TreeBox& box, const Double3& origin, const Double3& inverse, double reach) {
    const Double3 a{(box.lower.x - origin.x) * inverse.x, (box.lower.y - origin.y) * inverse.y,
                    (box.lower.z - origin.z) * inverse.z};
    const Double3 b{(box.upper.x - origin.x) * inverse.x, (box.upper.y - origin.y) * inverse.y,
                    (box.upper.z - origin.z) * inverse.z};
    const Double3 enter = minimum(a, b), leave = maximum(a, b);
    return std::max({enter.x, enter.y, enter.z, 0.0}) <= std::min({leave.x, leave.y, leave.z, reach});
}

template <typename Visit>
bool TriangleTree::visitAlongRay(const Double3& origin, const Double3& direction, const double& reach,
                                 Visit&& visit) const {
    const Double3 inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
    uint32_t stack[kMaxDepth + 1];
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const uint32_t id = stack[--size];
        const Node& node = nodes_[id];
        if (!rayMeetsBox(node.box, origin, inverse, reach)) continue;
        if (node.count == 0) {
            stack[size++] = node.first;
            stack[size++] = id + 1;
            continue;
        }
        for (uint32_t i = node.first; i < node.first + node.count; ++i)
            if (!visit(corners_[i], triangles_[i])) return false;
    }
    return true;
}

template <typename Visit>
void TriangleTree::visitNearest(const Double3& point, const double& bound_squared, Visit&& visit) const {
    std::pair<double, uint32_t> stack[kMaxDepth + 1];
    int size = 0;
    stack[size++] = {nodes_[0].box.distanceSquared(point), 0};
    while (size > 0) {
        const auto [distance, id] = stack[--size];
        if (distance > bound_squared) continue;
        const Node& node = nodes_[id];
        if (node.count > 0) {
            for (uint32_t i = node.first; i < node.first + node.count; ++i) visit(corners_[i], triangles_[i]);
            continue;
        }
        std::pair<double, uint32_t> nearer{nodes_[id + 1].box.distanceSquared(point), id + 1};
        std::pair<double, uint32_t> farther{nodes_[node.first].box.distanceSquared(point), node.first};
        if (farther.first < nearer.first) std::swap(nearer, farther);
        stack[size++] = farther;
        stack[size++] = nearer;
    }
}

}  // namespace demolish
