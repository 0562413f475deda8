// SPDX-License-Identifier: Apache-2.0
// One collider in memory, and what it is from a point.
#pragma once
#include <cstdint>

#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// What the rows of a collider say. Plane: (unit normal; offsetOf). Box: three times (unit axis; halfEdgeOf),
/// then (centre in m; 0). Round, a capsule: (one end in m; radiusOf), (to the other end in m; shareOf); a
/// sphere is one without length. Mesh: a box about it; the last number is stepOf.
enum class ColliderShape : uint32_t { kPlane, kBox, kRound, kMesh };

/// A collider from a point: the plane that touches it where it is nearest to that point.
template <class Real>
struct TangentPlane {
    Vec4<Real> plane;  ///< (unit outward normal, offset in m)
    Real distance{};   ///< m, of the point to the surface; negative inside
};

/// The nearest way off a collider from a point, along the collider's own axes.
template <class Real>
struct Away {
    Vec3<Real> out;   ///< unit
    Real distance{};  ///< m, as in TangentPlane
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
    ColliderShape shape = ColliderShape::kPlane;
    uint32_t counts = 0;      ///< of a mesh: packedCounts()
    Real margin{};            ///< m, of a mesh: by which its grid reaches beyond the box of the rows
    Real per_step{};          ///< 1/m, likewise: 1 over stepOf
    Span<const float> steps;  ///< of a mesh: DistanceNodes::steps
    Vec4<Real> row[4];        ///< as ColliderShape says
};

/// m, of a plane: dot(normal, x) of its points.
template <class Real>
DEM_FN Real offsetOf(const Vec4<Real>& plane) {
    return plane.w;
}
/// m, of a sphere or a capsule.
template <class Real>
DEM_FN Real radiusOf(const Vec4<Real>& centre) {
    return centre.w;
}
/// 1/m^2, of a capsule: 1 over the square of its line.
template <class Real>
DEM_FN Real shareOf(const Vec4<Real>& line) {
    return line.w;
}

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

/// Of a box or a mesh: a vector along its axes, and one that is given along them.
template <class Real>
DEM_FN Vec3<Real> alongAxes(const Vec4<Real> (&row)[4], const Vec3<Real>& v) {
    return {dot(xyz(row[0]), v), dot(xyz(row[1]), v), dot(xyz(row[2]), v)};
}
template <class Real>
DEM_FN Vec3<Real> turnedOut(const Vec4<Real> (&row)[4], const Vec3<Real>& v) {
    return axpy(v.x, xyz(row[0]), axpy(v.y, xyz(row[1]), v.z * xyz(row[2])));
}

/// `high` + `low`: the point (data/particles.h), m.
template <class Real>
DEM_FN TangentPlane<Real> tangentWith(const Vec3<Real>& normal, Real distance, const Vec3<Real>& high,
                                      const Vec3<Real>& low) {
    return {withW(normal, (dot(normal, high) - distance) + dot(normal, low)), distance};
}

}  // namespace demolish
