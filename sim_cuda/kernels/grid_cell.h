// SPDX-License-Identifier: Apache-2.0
// The uniform grid of the paper (3.3.1): counters and cells, but without its cap of 4. Space is unbounded:
// cells are hashed to buckets, and a particle keeps the key of its cell, so that strangers in a bucket are
// told apart.
#pragma once
#include "sim_cuda/data/contact_rows.h"

namespace demolish {

/// Where particles are binned: the middle of their path over the horizon, seen from the frame of the common
/// velocity. Two that may meet are then never farther apart than one cell.
template <class Real>
struct GridFrame {
    Vec3<Real> common_velocity;        ///< m/s
    Real horizon{};                    ///< s
    Real cell_size{}, inverse_cell{};  ///< m, 1/m
    uint32_t sets_apart = 0;           ///< 1: the fast are kept out of the grid (velocity_trim.h)
};

/// m, seen from the moving frame.
template <class Real>
DEM_FN Vec3<Real> middleOfPath(const GridFrame<Real>& frame, const Vec4<Real>& position,
                               const Vec4<Real>& velocity) {
    return axpy(Real(0.5) * frame.horizon, xyz(velocity) - frame.common_velocity, xyz(position));
}

/// (middle of the path, m; radius about it that holds the path and the reach, m). Two whose balls are apart
/// cannot meet. The excess covers round-off far from the origin.
template <class Real>
DEM_FN Vec4<Real> ballAroundPath(const GridFrame<Real>& frame, const Vec4<Real>& position,
                                 const Vec4<Real>& velocity) {
    const Real half_way = Real(0.5) * frame.horizon * length(xyz(velocity) - frame.common_velocity);
    return withW(middleOfPath(frame, position, velocity),
                 madd(Real(1.01), reachOf(position) + half_way, Real(0.005) * frame.cell_size));
}
template <class Real>
DEM_FN Real ballRadius(const Vec4<Real>& ball) {
    return ball.w;
}
template <class Real>
DEM_FN bool ballsTouch(const Vec4<Real>& a, const Vec4<Real>& b) {
    const Real reach = ballRadius(a) + ballRadius(b);
    return length2(xyz(b) - xyz(a)) < reach * reach;
}

inline constexpr int32_t kGridReach =
    1 << 20;  ///< cells from the origin to either side; farther ones share the last

struct GridCell {
    int32_t x = 0, y = 0, z = 0;
};

template <class Real>
DEM_FN int32_t gridCoordinate(Real scaled) {
    const Real inside = scaled > Real(1 - kGridReach)
                            ? (scaled < Real(kGridReach - 1) ? scaled : Real(kGridReach - 1))
                            : Real(1 - kGridReach);
    const int32_t whole = static_cast<int32_t>(inside);
    return static_cast<Real>(whole) > inside ? whole - 1 : whole;
}

template <class Real>
DEM_FN GridCell gridCell(const GridFrame<Real>& frame, const Vec4<Real>& position,
                         const Vec4<Real>& velocity) {
    const Vec3<Real> middle = middleOfPath(frame, position, velocity);
    return {gridCoordinate(frame.inverse_cell * middle.x), gridCoordinate(frame.inverse_cell * middle.y),
            gridCoordinate(frame.inverse_cell * middle.z)};
}

/// All three coordinates in one word, 21 bits each.
DEM_FN uint64_t cellKey(const GridCell& cell) {
    return static_cast<uint64_t>(cell.x + kGridReach) | static_cast<uint64_t>(cell.y + kGridReach) << 21 |
           static_cast<uint64_t>(cell.z + kGridReach) << 42;
}
DEM_FN GridCell cellOf(uint64_t key) {
    return {static_cast<int32_t>(key & 0x1fffffu) - kGridReach,
            static_cast<int32_t>(key >> 21 & 0x1fffffu) - kGridReach,
            static_cast<int32_t>(key >> 42 & 0x1fffffu) - kGridReach};
}

/// The row of cells along x that a key lies in: its y and z.
DEM_FN uint64_t cellRow(uint64_t key) {
    return key >> 21;
}

/// Cells of a row follow each other in the buckets, the last bucket being followed by the first, so that
/// three neighbours are read in one go. `mask` = number of buckets - 1, a power of two less one, at least 3.
DEM_FN uint32_t bucketOf(uint64_t key, uint32_t mask) {
    const uint64_t row = cellRow(key);
    const uint64_t mixed = (row ^ row >> 21) * 0x9e3779b97f4a7c15ull;
    return (static_cast<uint32_t>(mixed >> 40) + static_cast<uint32_t>(key & 0x1fffffu)) & mask;
}

}  // namespace demolish
