// SPDX-License-Identifier: Apache-2.0
// Which pairs without a bond record may touch before the lists are built again: rows sorted by id, both ends
// hold the pair. A projectile's row is long; it stands last, and the particles it may touch have it at the
// end of theirs. Built by solver/neighbour_lists.h.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/kept_spring.h"
#include "sim_cuda/data/sorted_row.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

template <class Real>
struct ContactRowsIn {
    Span<const uint32_t> row_start;  ///< total + 1
    Span<const uint32_t> neighbour;  ///< ids, ascending in each row
    Span<const Vec4<Real>> spring;   ///< kept_spring.h
};

/// The slot of j in the row of i; row_start[i + 1] when it is not listed.
DEM_FN uint32_t findContact(const Span<const uint32_t>& row_start, const Span<const uint32_t>& neighbour,
                            uint32_t i, uint32_t j) {
    return slotOfId(row_start[i], row_start[i + 1], j, [&](uint32_t slot) { return neighbour[slot]; });
}

/// Straight paths on which the lists rely: x(t) = x + v t from the build on (kernels/predicted_path.h).
template <class Real>
struct PathsIn {
    Span<const Vec4<Real>> position;  ///< total: (x at the build, m; reachOf)
    Span<const Vec4<Real>> velocity;  ///< total: (v at the build, m/s; skinOf)
};
/// m, of a path's position: R_c + skin; of a projectile more (kernels/start_paths.h).
template <class Real>
DEM_FN Real reachOf(const Vec4<Real>& path_position) {
    return path_position.w;
}
/// m, of a path's velocity; kNoPath of whom takes part in nothing.
template <class Real>
DEM_FN Real skinOf(const Vec4<Real>& path_velocity) {
    return path_velocity.w;
}
inline constexpr int kNoPath = -1;
template <class Real>
DEM_FN bool hasPath(const Vec4<Real>& path_velocity) {
    return skinOf(path_velocity) >= Real(0);
}

template <class Backend, class Real>
struct ContactArrays {
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    Buffer<uint32_t> row_start;
    Buffer<uint32_t> neighbour;  ///< capacity may exceed row_start[total]
    Buffer<Vec4<Real>> spring;
    Buffer<Vec4<Real>> built_position, built_velocity;  ///< PathsIn
    uint32_t used = 0;                                  ///< row_start[total]

    ContactRowsIn<Real> in() const { return {row_start.view(), neighbour.view(), spring.view()}; }
    PathsIn<Real> paths() const { return {built_position.view(), built_velocity.view()}; }
};

}  // namespace demolish
