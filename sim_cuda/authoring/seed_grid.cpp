// SPDX-License-Identifier: Apache-2.0
// Counting sort of the seeds into grid cells, and the nearest seed of a point.
#include "sim_cuda/authoring/seed_grid.h"

#include "sim_cuda/authoring/bounds.h"

namespace demolish {

SeedGrid::SeedGrid(const std::vector<Double3>& seeds, double spacing) : step_(spacing) {
    const Bounds bounds = boundsOf(seeds);
    lower_ = bounds.lower;
    const Double3 size = bounds.size();
    const double most_cells = 64.0 * double(seeds.size()) + 4096;
    while ((size.x / step_ + 1) * (size.y / step_ + 1) * (size.z / step_ + 1) > most_cells) step_ *= 1.25;
    nx_ = int(size.x / step_) + 1;
    ny_ = int(size.y / step_) + 1;
    nz_ = int(size.z / step_) + 1;

    start_.assign(size_t(nx_) * size_t(ny_) * size_t(nz_) + 1, 0);
    for (const Double3& p : seeds) ++start_[index(placeOf(p)) + 1];
    for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
    ids_.resize(seeds.size());
    positions_.resize(seeds.size());
    for (uint32_t id = 0; id < seeds.size(); ++id) {
        const uint32_t slot = next[index(placeOf(seeds[id]))]++;
        ids_[slot] = id;
        positions_[slot] = seeds[id];
    }
}

double SeedGrid::ringDistance(const Double3& p, const Place& at, int ring) const {
    double bound = std::numeric_limits<double>::infinity();
    const auto axis = [&](double coordinate, double lower, int cell, int count) {
        if (cell - ring >= 0) bound = std::min(bound, coordinate - (lower + (cell - ring + 1) * step_));
        if (cell + ring < count) bound = std::min(bound, lower + (cell + ring) * step_ - coordinate);
    };
    axis(p.x, lower_.x, at.x, nx_);
    axis(p.y, lower_.y, at.y, ny_);
    axis(p.z, lower_.z, at.z, nz_);
    return bound;
}

uint32_t SeedGrid::nearest(const Double3& p) const {
    const Place at = placeOf(p);
    double best = std::numeric_limits<double>::infinity();
    uint32_t nearest_id = 0;
    for (int ring = 0;; ++ring) {
        const double bound = ringDistance(p, at, ring);
        if (ring > 0 &&
            (bound == std::numeric_limits<double>::infinity() || (bound > 0 && bound * bound > best)))
            return nearest_id;
        visitRing(at, ring, [&](uint32_t id, const Double3& seed) {
            const double distance = lengthSquared(seed - p);
            if (distance < best || (distance == best && id < nearest_id)) {
                best = distance;
                nearest_id = id;
            }
        });
    }
}

}  // namespace demolish
