// SPDX-License-Identifier: Apache-2.0
// Static rigid shapes: signed distance and outward normal of each at a point, and the one loop over them that
// contacts, predictions, lists and books share. All of them are convex: a solid lies behind its tangent
// planes, so that what stays clear of one stays clear of the solid.
#pragma once
#include <variant>
#include <vector>

#include "sim_cuda/api/params.h"
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// What the rows of a collider say.
enum class ColliderShape : uint32_t { kPlane, kBox };

/// A collider from a point: the plane that touches it where it is nearest to that point.
template <class Real>
struct TangentPlane {
    Vec4<Real> plane;  ///< (unit outward normal, offset in m)
    Real distance{};   ///< m, of the point to the surface; negative inside
};

/// One collider: its shape and four rows.
template <class Real>
struct ColliderRows {
    ColliderShape shape = ColliderShape::kPlane;
    /// Plane: (unit normal; offsetOf). Box: three times (unit axis; halfEdgeOf), then (centre in m; 0).
    Vec4<Real> row[4];
};
/// m, of a plane: dot(normal, x) of its points.
template <class Real>
DEM_FN Real offsetOf(const Vec4<Real>& plane) {
    return plane.w;
}
/// m, of a box along an axis.
template <class Real>
DEM_FN Real halfEdgeOf(const Vec4<Real>& axis) {
    return axis.w;
}

/// `high` + `low`: the point (data/particles.h), m; likewise in what follows.
template <class Real>
DEM_FN TangentPlane<Real> tangentOfPlane(const Vec4<Real>& plane, const Vec3<Real>& high,
                                         const Vec3<Real>& low) {
    return {plane, (dot(xyz(plane), high) - offsetOf(plane)) + dot(xyz(plane), low)};
}

/// 1 with the sign of x, which is 1 for 0 as well.
template <class Real>
DEM_FN Real signOf(Real x) {
    return x < Real(0) ? Real(-1) : Real(1);
}

/// Of a face the distance and the normal are those of the plane through it, to the last bit but for the
/// offset's rounding; so they are inside, where the nearest face counts. Beyond two or three faces it is the
/// edge or the corner.
template <class Real>
DEM_FN TangentPlane<Real> tangentOfBox(const Vec4<Real> (&row)[4], const Vec3<Real>& high,
                                       const Vec3<Real>& low) {
    const Vec3<Real> from_centre = (high - xyz(row[3])) + low;
    const Vec3<Real> at{dot(xyz(row[0]), from_centre), dot(xyz(row[1]), from_centre),
                        dot(xyz(row[2]), from_centre)};
    const Vec3<Real> past{absOf(at.x) - halfEdgeOf(row[0]), absOf(at.y) - halfEdgeOf(row[1]),
                          absOf(at.z) - halfEdgeOf(row[2])};
    const Real most = maxOf(past.x, maxOf(past.y, past.z));
    const Vec3<Real> beyond{maxOf(past.x, Real(0)), maxOf(past.y, Real(0)), maxOf(past.z, Real(0))};
    const Real squared = length2(beyond), inverse = inverseSqrt(squared);
    const bool at_face = !(squared > most * most) || !(inverse > Real(0));
    const bool is_x = past.x == most, is_y = !is_x && past.y == most;
    const Vec3<Real> face{Real(is_x ? 1 : 0), Real(is_y ? 1 : 0), Real(is_x || is_y ? 0 : 1)};
    const Vec3<Real> out = at_face ? face : inverse * beyond;
    const Real distance = at_face ? most : squared * inverse;
    const Vec3<Real> normal =
        axpy(signOf(at.x) * out.x, xyz(row[0]),
             axpy(signOf(at.y) * out.y, xyz(row[1]), (signOf(at.z) * out.z) * xyz(row[2])));
    return {withW(normal, (dot(normal, high) - distance) + dot(normal, low)), distance};
}

/// What a kernel takes with it; plain memory. The spring of particle i against collider c is element
/// c * total + i of the collider springs: (tangential spring seen from the particle in m; as in contacts).
template <class Real>
struct ColliderSet {
    ColliderRows<Real> collider[kMaxColliders];
    uint32_t count = 0;

    DEM_FN bool isPlane(uint32_t c) const { return collider[c].shape == ColliderShape::kPlane; }
    DEM_FN TangentPlane<Real> tangent(uint32_t c, const Vec3<Real>& high, const Vec3<Real>& low = {}) const {
        const ColliderRows<Real>& rows = collider[c];
        if (rows.shape == ColliderShape::kBox) return tangentOfBox(rows.row, high, low);
        return tangentOfPlane(rows.row[0], high, low);
    }
};

/// Calls visit(c, tangent) for every collider in turn.
template <class Real, class Visit>
DEM_FN void forEachCollider(const ColliderSet<Real>& colliders, const Vec3<Real>& high, const Vec3<Real>& low,
                            const Visit& visit) {
    for (uint32_t c = 0; c < colliders.count; ++c) visit(c, colliders.tangent(c, high, low));
}
template <class Real, class Visit>
DEM_FN void forEachCollider(const ColliderSet<Real>& colliders, const Vec3<Real>& point, const Visit& visit) {
    forEachCollider(colliders, point, Vec3<Real>{}, visit);
}

template <class Real>
Vec4<Real> colliderRow(const Vec3<double>& a, double w) {
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z), static_cast<Real>(w)};
}

template <class Real>
ColliderRows<Real> rowsOf(const Plane& plane) {
    const Double3& n = plane.normal;
    return {ColliderShape::kPlane, {colliderRow<Real>({n.x, n.y, n.z}, plane.offset)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Box& box) {
    const auto q = normalized(Quat<double>{box.rotation.x, box.rotation.y, box.rotation.z, box.rotation.w});
    const Double3 &size = box.size, &at = box.position;
    return {ColliderShape::kBox,
            {colliderRow<Real>(rotate(q, {1, 0, 0}), size.x / 2),
             colliderRow<Real>(rotate(q, {0, 1, 0}), size.y / 2),
             colliderRow<Real>(rotate(q, {0, 0, 1}), size.z / 2), colliderRow<Real>({at.x, at.y, at.z}, 0)}};
}

/// At most kMaxColliders.
template <class Real>
ColliderSet<Real> makeColliderSet(const std::vector<Collider>& colliders) {
    ColliderSet<Real> set;
    for (const Collider& collider : colliders)
        set.collider[set.count++] =
            std::visit([](const auto& shape) { return rowsOf<Real>(shape); }, collider);
    return set;
}

}  // namespace demolish
