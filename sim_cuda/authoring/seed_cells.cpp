// SPDX-License-Identifier: Apache-2.0
// Counting sort of seeds by cell.
#include "sim_cuda/authoring/seed_cells.h"

#include <tbb/parallel_for.h>

#include "sim_cuda/authoring/bounds.h"

namespace demolish {

SeedCells::SeedCells(const std::vector<Double3>& seeds, double reach)
    : seeds_(seeds.size()), positions_(seeds.size()) {
    const Bounds bounds = boundsOf(seeds);
    lower_ = bounds.lower;
    const Double3 extent = bounds.size();
    // Thin shells spread over a large box: wider cells keep their number in proportion to the seeds.
    double cell = reach;
    const double most_cells = 8.0 * double(seeds.size()) + 4096;
    const auto cells_at = [&](double size) {
        return (std::floor(extent.x / size) + 1) * (std::floor(extent.y / size) + 1) *
               (std::floor(extent.z / size) + 1);
    };
    while (cells_at(cell) > most_cells) cell *= 1.25;
    per_cell_ = 1 / cell;
    nx_ = int(extent.x * per_cell_) + 1;
    ny_ = int(extent.y * per_cell_) + 1;
    nz_ = int(extent.z * per_cell_) + 1;

    std::vector<uint32_t> cell_of(seeds.size());
    tbb::parallel_for(size_t(0), seeds.size(), [&](size_t i) {
        const Place at = placeOf(seeds[i]);
        cell_of[i] = uint32_t((size_t(at.z) * size_t(ny_) + size_t(at.y)) * size_t(nx_) + size_t(at.x));
    });
    start_.assign(size_t(nx_) * size_t(ny_) * size_t(nz_) + 1, 0);
    for (const uint32_t c : cell_of) ++start_[c + 1];
    for (size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
    for (uint32_t i = 0; i < seeds.size(); ++i) {
        const uint32_t slot = next[cell_of[i]]++;
        seeds_[slot] = i;
        positions_[slot] = seeds[i];
    }
}

}  // namespace demolish
