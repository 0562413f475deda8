// Which pairs without a bond record may touch before the lists are built again: rows sorted by id, both ends
// hold the pair. A projectile's row is long; it stands last, and the particles it may touch have it at the
// end of theirs.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

template <class Real>
struct ContactRowsIn {
    Span<const uint32_t> row_start;  ///< total + 1
    Span<const uint32_t> neighbour;  ///< ids, ascending in each row
    Span<const Vec4<Real>>
        spring;  ///< (tangential spring seen from the row's particle, m; 0), null when not touching
};

template <class Backend, class Real>
struct ContactArrays {
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    Buffer<uint32_t> row_start;
    Buffer<uint32_t> neighbour;  ///< capacity may exceed row_start[total]
    Buffer<Vec4<Real>> spring;
    Buffer<Vec4<Real>> built_position;  ///< total; state.position at the last build
    Buffer<Real> skin;                  ///< m, total; chosen from each particle's speed before every build
    uint32_t used = 0;                  ///< row_start[total]

    ContactRowsIn<Real> in() const { return {row_start.view(), neighbour.view(), spring.view()}; }
};

/// A pair is listed when its distance at the build is below R_c,i + skin_i + R_c,j + skin_j, unless the pair
/// has a bond record; the lists are built again before any particle has moved by its skin (against the common
/// motion of all).
struct ContactReach {
    double largest_in_bodies =
        0;  ///< m, upper bound of R_c + skin of the bodies' particles: sets the grid's cells
};

}  // namespace demolish
