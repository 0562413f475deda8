// SPDX-License-Identifier: Apache-2.0
// Seeds sorted into cubic cells for searches that widen ring by ring (geometry.md 2.2).
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

class SeedGrid {
  public:
    struct Place {
        int x, y, z;
    };

    /// `spacing` (m): side of a grid cell, enlarged where that would make far more cells than seeds.
    SeedGrid(const std::vector<Double3>& seeds, double spacing);

    /// Nearest seed; of equally near ones the lowest id.
    uint32_t nearest(const Double3& p) const;

    /// Grid cell of `p`; for points outside the grid the nearest one.
    Place placeOf(const Double3& p) const {
        return {clamped((p.x - lower_.x) / step_, nx_), clamped((p.y - lower_.y) / step_, ny_),
                clamped((p.z - lower_.z) / step_, nz_)};
    }

    /// Lower bound (m) for the distance from `p` (whose place is `at`) to the seeds of ring `ring` and
    /// beyond; infinite when there are none.
    double ringDistance(const Double3& p, const Place& at, int ring) const;

    /// Calls visit(id, position) for every seed in the cells at Chebyshev distance `ring` from `at`.
    template <typename Visit>
    void visitRing(const Place& at, int ring, Visit&& visit) const {
        const int z_end = std::min(at.z + ring, nz_ - 1), y_end = std::min(at.y + ring, ny_ - 1);
        for (int z = std::max(at.z - ring, 0); z <= z_end; ++z)
            for (int y = std::max(at.y - ring, 0); y <= y_end; ++y) {
                const bool is_shell_row = std::abs(z - at.z) == ring || std::abs(y - at.y) == ring;
                if (is_shell_row) {
                    visitRow(std::max(at.x - ring, 0), std::min(at.x + ring, nx_ - 1), y, z, visit);
                } else {
                    if (at.x - ring >= 0) visitRow(at.x - ring, at.x - ring, y, z, visit);
                    if (at.x + ring < nx_) visitRow(at.x + ring, at.x + ring, y, z, visit);
                }
            }
    }

  private:
    static int clamped(double cell, int count) {
        return cell > 0 ? (cell < count - 1 ? int(cell) : count - 1) : 0;
    }
    size_t index(const Place& at) const {
        return (size_t(at.z) * size_t(ny_) + size_t(at.y)) * size_t(nx_) + size_t(at.x);
    }
    template <typename Visit>
    void visitRow(int x_first, int x_last, int y, int z, Visit& visit) const {
        const size_t row = index({0, y, z});
        const uint32_t end = start_[row + size_t(x_last) + 1];
        for (uint32_t slot = start_[row + size_t(x_first)]; slot < end; ++slot)
            visit(ids_[slot], positions_[slot]);
    }

    Double3 lower_;
    double step_ = 1;
    int nx_ = 1, ny_ = 1, nz_ = 1;
    std::vector<uint32_t> start_;  // by grid cell, one past the end included
    std::vector<uint32_t> ids_;    // ascending within a grid cell
    std::vector<Double3> positions_;
};

}  // namespace demolish
