// SPDX-License-Identifier: Apache-2.0
// How long the lists of a build are to hold, and the grid that follows from it. Decided on the device, so
// that nobody waits for it; in double precision from whole sets of numbers, so that every device decides
// alike.
#pragma once
#include <bit>

#include "sim_cuda/kernels/grid_cell.h"
#include "sim_cuda/kernels/velocity_trim.h"

namespace demolish {

/// Words in which the host is told of the horizon: the bits of a double, low word first.
inline constexpr uint32_t kHorizonWords = 2;

/// Travel of those who are set apart, over the reach: how long their rows may get.
inline constexpr double kFastTravel = 4;
/// Nobody is set apart for less.
inline constexpr double kWorthSettingApart = 1.5;

/// One thread. The horizon is as long as the grid's cells allow: travel_share of the reach for the fastest
/// particle in it, seen from the middle of all velocities, and shot_travel reaches for the fastest
/// projectile.
template <class Real>
struct ChooseFrame {
    Span<const VelocityRanges<Real>> ranges;  ///< one
    Span<const SlowBins> slow;                ///< one
    Span<const uint32_t> fast;                ///< one: how many are outside
    Span<GridFrame<Real>> frame;              ///< one
    Span<uint32_t> told;                      ///< kHorizonWords
    double reach = 0;                         ///< m, of two particles of the largest radius
    double travel_share = 0, longest_horizon = 0, shot_travel = 4;

    DEM_FN void operator()(uint32_t) const {
        GridFrame<Real> chosen;
        const VelocityRange<Real>& all = ranges[0].bodies;
        VelocityRange<Real> gridded = all;
        double horizon = horizonOf(gridded);
        if (horizon < longest_horizon && fast[0] > 0 && fast[0] <= kMostFast) {
            const VelocityRange<Real> range = slowRange(all, slow[0]);
            double apart = horizonOf(range);
            const double fastest = largestSpeed(all, middleOf(range));
            if (fastest * apart > kFastTravel * reach) apart = kFastTravel * reach / fastest;
            if (apart > kWorthSettingApart * horizon) {
                gridded = range;
                horizon = apart;
                chosen.sets_apart = 1;
            }
        }
        chosen.common_velocity = middleOf(gridded);
        const double spread = largestSpeed(gridded, chosen.common_velocity);
        const double shot_speed = largestSpeed(ranges[0].projectiles, chosen.common_velocity);
        if (shot_speed * horizon > shot_travel * reach) horizon = shot_travel * reach / shot_speed;
        chosen.horizon = static_cast<Real>(horizon);
        horizon = static_cast<double>(chosen.horizon);
        // 2 %: round-off of positions far from the origin (up to 5e4 cells in float).
        const double cell = 1.02 * (reach + spread * horizon);
        chosen.cell_size = static_cast<Real>(cell);
        chosen.inverse_cell = static_cast<Real>(1 / cell);
        frame[0] = chosen;
        const uint64_t bits = std::bit_cast<uint64_t>(horizon);
        told[0] = static_cast<uint32_t>(bits);
        told[1] = static_cast<uint32_t>(bits >> 32);
    }

  private:
    /// s, for bodies with these velocities in the grid.
    DEM_FN double horizonOf(const VelocityRange<Real>& range) const {
        const double spread = largestSpeed(range, middleOf(range));
        const double travel = travel_share * reach;
        return spread * longest_horizon > travel ? travel / spread : longest_horizon;
    }
};

}  // namespace demolish
