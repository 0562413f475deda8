// SPDX-License-Identifier: Apache-2.0
// One collider in memory, and what it is from a point.
#pragma once
#include <cstdint>

#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

enum class ColliderShape : uint32_t;  // colliders.h

/// A collider from a point: the plane that touches it where it is nearest to that point.
template <class Real>
struct TangentPlane {
    Vec4<Real> plane;  ///< (unit outward normal, offset in m)
    Real distance{};   ///< m, of the point to the surface; negative inside
};

/// How a point on its way comes towards a collider: no sooner than a plane at this distance that it nears at
/// this speed.
template <class Real>
struct Approach {
    Real distance{};  ///< m
    Real speed{};     ///< m/s
};

/// One collider: its shape and four rows.
template <class Real>
struct ColliderRows {
    ColliderShape shape{};
    uint32_t counts = 0;      ///< of a mesh: packedCounts()
    Real margin{};            ///< m, of a mesh: by which its grid reaches beyond the box of the rows
    Span<const float> steps;  ///< of a mesh: DistanceNodes::steps
    Vec4<Real> row[4];        ///< as ColliderShape says
};

/// m, of a box along an axis.
template <class Real>
DEM_FN Real halfEdgeOf(const Vec4<Real>& axis) {
    return axis.w;
}

/// m, between nodes of a mesh's grid.
template <class Real>
DEM_FN Real stepOf(const Vec4<Real>& centre) {
    return centre.w;
}

}  // namespace demolish
