// SPDX-License-Identifier: Apache-2.0
// What of a particle meets colliders: the corners of its cell, or a sphere where it has none.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// A particle's corners: first .. last-1. None: a sphere of its floor radius.
template <class Real>
struct CornerRow {
    uint32_t first = 0, last = 0;
    Real inner_radius{};  ///< m, of a sphere within the cell: edges of colliders reach between its corners
};

/// Bodies of one shape share their corners; projectiles have empty rows.
template <class Real>
struct CornersIn {
    Span<const CornerRow<Real>> row;   ///< per particle and projectile slot
    Span<const Vec4<Real>> from_seed;  ///< (x y z in m; 0), where the particle's rotation is 1
};

/// Those of one particle, in whatever memory.
template <class Real>
struct OwnCorners {
    Span<const Vec4<Real>> from_seed;  ///< as CornersIn has it; none: a sphere of the floor radius
    Real inner_radius{};               ///< m, as CornerRow has it
};
template <class Real>
DEM_FN OwnCorners<Real> cornersOf(const CornersIn<Real>& corners, uint32_t i) {
    const CornerRow<Real> row = corners.row[i];
    return {corners.from_seed.part(row.first, row.last - row.first), row.inner_radius};
}

}  // namespace demolish
