// SPDX-License-Identifier: Apache-2.0
// Seeds sorted into cubic cells: who is near whom during the packing.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// A snapshot of the seeds in cell order (within a cell by id, so sums run in a fixed order). A slot is a
/// place in it.
class SeedCells {
  public:
    /// `reach` (m): all pairs nearer than it are found. At least one seed.
    SeedCells(const std::vector<Double3>& seeds, double reach);

    const Double3& position(size_t slot) const { return positions_[slot]; }
    uint32_t seed(size_t slot) const { return seeds_[slot]; }

    /// Calls visit(slot) for every other slot in the 27 cells around.
    template <typename Visit>
    void visitNear(size_t slot, Visit&& visit) const {
        const Place at = placeOf(positions_[slot]);
        const int x_begin = std::max(at.x - 1, 0), x_last = std::min(at.x + 1, nx_ - 1);
        for (int z = std::max(at.z - 1, 0); z <= std::min(at.z + 1, nz_ - 1); ++z)
            for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, ny_ - 1); ++y) {
                const size_t row = (size_t(z) * size_t(ny_) + size_t(y)) * size_t(nx_);
                const uint32_t end = start_[row + size_t(x_last) + 1];  // cells of a row follow each other
                for (uint32_t other = start_[row + size_t(x_begin)]; other < end; ++other)
                    if (other != slot) visit(size_t(other));
            }
    }

  private:
    struct Place {
        int x, y, z;
    };
    Place placeOf(const Double3& p) const {
        return {std::min(int((p.x - lower_.x) * per_cell_), nx_ - 1),
                std::min(int((p.y - lower_.y) * per_cell_), ny_ - 1),
                std::min(int((p.z - lower_.z) * per_cell_), nz_ - 1)};
    }

    Double3 lower_;
    double per_cell_ = 1;  // 1 / m
    int nx_ = 1, ny_ = 1, nz_ = 1;
    std::vector<uint32_t> start_;  // by cell, one past the end included
    std::vector<uint32_t> seeds_;
    std::vector<Double3> positions_;
};

}  // namespace demolish
