// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/painted_bonds.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/physics/painted_strength.h"

namespace demolish {
namespace {

constexpr int kParts = 4;  // of a bond: a value at the end of each

/// Of the outside nearest to a place, 0 to 1, linear between the corners of a triangle.
class PaintedOutside {
  public:
    PaintedOutside(const TriangleMesh& mesh, const MeshQueries& queries, PaintChannel channel)
        : mesh_(mesh), queries_(queries), shift_(8 * static_cast<int>(channel)) {}

    double valueAt(const Double3& place) const {
        const ClosestPoint nearest = queries_.closestPoint(place);
        const auto& corner = mesh_.triangles[nearest.triangle];
        const Double3 &a = mesh_.positions[corner[0]], &b = mesh_.positions[corner[1]],
                      &c = mesh_.positions[corner[2]];
        const Double3 normal = cross(b - a, c - a), from = nearest.point - a;
        const double squared = dot(normal, normal);
        if (!(squared > 0)) return corners(nearest.triangle, {1, 0, 0});
        const double at_b = dot(normal, cross(from, c - a)) / squared,
                     at_c = dot(normal, cross(b - a, from)) / squared;
        return corners(nearest.triangle, {1 - at_b - at_c, at_b, at_c});
    }

  private:
    double corners(uint32_t triangle, const Double3& weights) const {
        const auto& of = mesh_.corners[triangle];
        const auto value = [&](size_t k) { return static_cast<double>(of[k].colour >> shift_ & 0xffu); };
        return std::clamp((weights.x * value(0) + weights.y * value(1) + weights.z * value(2)) / 255, 0.0,
                          1.0);
    }

    const TriangleMesh& mesh_;
    const MeshQueries& queries_;
    int shift_;
};

}  // namespace

std::vector<double> paintedBonds(const TriangleMesh& mesh, const MeshQueries& queries,
                                 const std::vector<Double3>& seeds, const std::vector<BondGeometry>& bonds,
                                 const PaintedStrength& painted) {
    const PaintedOutside outside(mesh, queries, painted.channel);
    std::vector<double> at_seed(seeds.size()), factors(bonds.size());
    tbb::parallel_for(size_t(0), seeds.size(), [&](size_t i) { at_seed[i] = outside.valueAt(seeds[i]); });
    tbb::parallel_for(size_t(0), bonds.size(), [&](size_t b) {
        const Double3 &from = seeds[bonds[b].i], way = seeds[bonds[b].j] - from;
        double least = std::min(at_seed[bonds[b].i], at_seed[bonds[b].j]);
        for (int part = 1; part < kParts; ++part)
            least = std::min(least, outside.valueAt(from + way * (double(part) / kParts)));
        factors[b] = paintedStrength(least, painted.least);
    });
    return factors;
}

}  // namespace demolish
