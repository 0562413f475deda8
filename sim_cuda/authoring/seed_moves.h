// SPDX-License-Identifier: Apache-2.0
// What moves the seeds of a packing: they push each other, and the surface pushes them.
#pragma once
#include <tbb/parallel_for.h>

#include <cmath>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/seed_cells.h"
#include "sim_cuda/authoring/spacing_field.h"

namespace demolish {

inline constexpr double kReach = 1.12;  ///< spacings, d0: nearer pairs repel
inline constexpr double kDepth = 0.45;  ///< spacings, wanted distance from the surface
inline constexpr uint64_t kCoincidentStream = 2;

template <typename Body>
void forEachSeed(size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 256),
                      [&](const tbb::blocked_range<size_t>& range) {
                          for (size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
}

/// m, that each seed is to have round it.
class SeedSpacings {
  public:
    SeedSpacings(const SpacingField& field, const std::vector<Double3>& seeds) : of_(seeds.size()) {
        forEachSeed(seeds.size(), [&](size_t i) { of_[i] = field.at(seeds[i]); });
    }
    double operator[](size_t seed) const { return of_[seed]; }
    double between(uint32_t a, uint32_t b) const { return 0.5 * (of_[a] + of_[b]); }

  private:
    std::vector<double> of_;
};

/// Sum of the pushes (m) of those near a slot that `counts(seed)` (geometry 1 b).
template <typename Counts>
Double3 repulsion(const SeedCells& cells, size_t slot, const SeedSpacings& spacings, uint64_t random,
                  const Counts& counts) {
    const Double3 p = cells.position(slot);
    const uint32_t own = cells.seed(slot);
    Double3 push;
    int neighbours = 0;
    cells.visitNear(slot, [&](size_t other) {
        const Double3 apart = p - cells.position(other);
        const double squared = lengthSquared(apart), spacing = spacings.between(own, cells.seed(other)),
                     reach = kReach * spacing;
        if (squared >= reach * reach || !counts(cells.seed(other))) return;
        ++neighbours;
        const double distance = std::sqrt(squared);
        if (distance > 1e-12 * spacing) {
            push += apart * ((reach - distance) / distance);
        } else {
            push += normalized(hashRandomInCube(random, kCoincidentStream, own)) * reach;
        }
    });
    return neighbours == 0 ? Double3{} : push * std::min(0.5, 1.6 / neighbours);
}

/// One projection to the wanted depth (m). A step that would leave it shallower (a wall too thin for it) is
/// halved.
inline Double3 deeper(const DistanceGrid& grid, const Double3& p, double wanted) {
    const double depth = -grid.distance(p);
    double step = wanted - depth;
    if (step <= 0) return p;
    const Double3 inward = -normalized(grid.gradient(p));
    for (int attempt = 0; attempt < 4; ++attempt, step /= 2) {
        const Double3 moved = p + inward * step;
        if (-grid.distance(moved) > depth) return moved;
    }
    return p;
}
/// Two projections (geometry 1 c).
inline Double3 deepEnough(const DistanceGrid& grid, const Double3& p, double wanted) {
    return deeper(grid, deeper(grid, p, wanted), wanted);
}

}  // namespace demolish
