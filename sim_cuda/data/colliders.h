// SPDX-License-Identifier: Apache-2.0
// Static rigid shapes: signed distance and outward normal of each at a point, and the one loop over them that
// contacts, predictions, lists and books share. All but meshes are convex: such a solid lies behind its
// tangent planes, so that what stays clear of one stays clear of the solid. A mesh lies in a box that does.
#pragma once
#include <variant>
#include <vector>

#include "sim_cuda/api/params.h"
#include "sim_cuda/data/collider_rows.h"
#include "sim_cuda/data/mesh_field.h"

namespace demolish {

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

/// `at`: from the box's centre along its axes, m. Of a face the distance and the direction are those of the
/// plane through it, to the last bit; so they are inside, where the nearest face counts. Beyond two or three
/// faces it is the edge or the corner.
template <class Real>
DEM_FN Away<Real> awayFromBox(const Vec4<Real> (&row)[4], const Vec3<Real>& at) {
    const Vec3<Real> past{absOf(at.x) - halfEdgeOf(row[0]), absOf(at.y) - halfEdgeOf(row[1]),
                          absOf(at.z) - halfEdgeOf(row[2])};
    const Real most = maxOf(past.x, maxOf(past.y, past.z));
    const Vec3<Real> beyond{maxOf(past.x, Real(0)), maxOf(past.y, Real(0)), maxOf(past.z, Real(0))};
    const Real squared = length2(beyond), inverse = inverseSqrt(squared);
    const bool at_face = !(squared > most * most) || !(inverse > Real(0));
    const bool is_x = past.x == most, is_y = !is_x && past.y == most;
    const Vec3<Real> face{Real(is_x ? 1 : 0), Real(is_y ? 1 : 0), Real(is_x || is_y ? 0 : 1)};
    const Vec3<Real> out = at_face ? face : inverse * beyond;
    return {{signOf(at.x) * out.x, signOf(at.y) * out.y, signOf(at.z) * out.z},
            at_face ? most : squared * inverse};
}

/// m^2, nearer to a ball's centre any direction is as good.
inline constexpr double kAtCentre = 1e-24;

/// Of the ball about the nearest point of a line; `at`: from its end, m.
template <class Real>
DEM_FN Away<Real> awayFromRound(const Vec4<Real> (&row)[4], const Vec3<Real>& at) {
    const Real along = clampTo(dot(at, xyz(row[1])) * shareOf(row[1]), Real(0), Real(1));
    const Vec3<Real> from_line = axpy(-along, xyz(row[1]), at);
    const Real squared = length2(from_line), inverse = inverseSqrt(squared);
    return {squared > Real(kAtCentre) ? inverse * from_line : Vec3<Real>{Real(0), Real(1), Real(0)},
            squared * inverse - radiusOf(row[0])};
}

template <class Real>
DEM_FN TangentPlane<Real> tangentOfBox(const Vec4<Real> (&row)[4], const Vec3<Real>& high,
                                       const Vec3<Real>& low) {
    const Away<Real> away = awayFromBox(row, alongAxes(row, (high - xyz(row[3])) + low));
    return tangentWith(turnedOut(row, away.out), away.distance, high, low);
}
template <class Real>
DEM_FN TangentPlane<Real> tangentOfRound(const Vec4<Real> (&row)[4], const Vec3<Real>& high,
                                         const Vec3<Real>& low) {
    const Away<Real> away = awayFromRound(row, (high - xyz(row[0])) + low);
    return tangentWith(away.out, away.distance, high, low);
}

/// What a kernel takes with it; plain memory. The spring of particle i against collider c is element
/// c * total + i of the collider springs: (tangential spring seen from the particle in m; as in contacts).
template <class Real>
struct ColliderSet {
    ColliderRows<Real> collider[kMaxColliders];
    uint32_t count = 0;

    DEM_FN bool isPlane(uint32_t c) const { return collider[c].shape == ColliderShape::kPlane; }
    DEM_FN bool isMesh(uint32_t c) const { return collider[c].shape == ColliderShape::kMesh; }
    bool arePlanes() const {
        for (uint32_t c = 0; c < count; ++c)
            if (!isPlane(c)) return false;
        return true;
    }
    DEM_FN TangentPlane<Real> tangent(uint32_t c, const Vec3<Real>& high, const Vec3<Real>& low = {}) const {
        return isMesh(c) ? tangentOfMesh(collider[c], high, low) : bound(c, high, low);
    }
    /// Of a mesh that of the box about it, which is nearer and read without memory; else tangent().
    DEM_FN TangentPlane<Real> bound(uint32_t c, const Vec3<Real>& high, const Vec3<Real>& low = {}) const {
        const ColliderRows<Real>& rows = collider[c];
        if (rows.shape == ColliderShape::kPlane) return tangentOfPlane(rows.row[0], high, low);
        if (rows.shape == ColliderShape::kRound) return tangentOfRound(rows.row, high, low);
        return tangentOfBox(rows.row, high, low);
    }
    /// Of a point that goes straight on from here.
    DEM_FN Approach<Real> approach(uint32_t c, const Vec3<Real>& point, const Vec3<Real>& velocity) const {
        const TangentPlane<Real> clear = bound(c, point);
        if (!isMesh(c) || clear.distance > Real(0)) return {clear.distance, -dot(xyz(clear.plane), velocity)};
        return {sureDistance(tangentOfMesh(collider[c], point, Vec3<Real>{}).distance), length(velocity)};
    }
};

/// Calls visit(c, bound) for every collider in turn. Colliders: ColliderSet or PlanesOnly.
template <class Colliders, class Real, class Visit>
DEM_FN void forEachCollider(const Colliders& colliders, const Vec3<Real>& high, const Vec3<Real>& low,
                            const Visit& visit) {
    for (uint32_t c = 0; c < colliders.count; ++c) visit(c, colliders.bound(c, high, low));
}
/// Calls visit(c, tangent) for every collider in turn.
template <class Real, class Visit>
DEM_FN void forEachCollider(const ColliderSet<Real>& colliders, const Vec3<Real>& point, const Visit& visit) {
    for (uint32_t c = 0; c < colliders.count; ++c) visit(c, colliders.tangent(c, point));
}

template <class Real>
Vec4<Real> colliderRow(const Vec3<double>& a, double w) {
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z), static_cast<Real>(w)};
}

template <class Real>
ColliderRows<Real> rowsOf(const Plane& plane) {
    const Double3& n = plane.normal;
    return {ColliderShape::kPlane, 0, 0, 0, {}, {colliderRow<Real>({n.x, n.y, n.z}, plane.offset)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Box& box) {
    const auto q = normalized(Quat<double>{box.rotation.x, box.rotation.y, box.rotation.z, box.rotation.w});
    const Double3 &size = box.size, &at = box.position;
    return {ColliderShape::kBox,
            0,
            0,
            0,
            {},
            {colliderRow<Real>(rotate(q, {1, 0, 0}), size.x / 2),
             colliderRow<Real>(rotate(q, {0, 1, 0}), size.y / 2),
             colliderRow<Real>(rotate(q, {0, 0, 1}), size.z / 2), colliderRow<Real>({at.x, at.y, at.z}, 0)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Sphere& ball) {
    const Double3& at = ball.position;
    return {ColliderShape::kRound, 0, 0, 0, {}, {colliderRow<Real>({at.x, at.y, at.z}, ball.radius)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Capsule& rod) {
    const Vec3<double> from{rod.from.x, rod.from.y, rod.from.z}, to{rod.to.x, rod.to.y, rod.to.z};
    const Vec3<double> line = to - from;
    return {ColliderShape::kRound,
            0,
            0,
            0,
            {},
            {colliderRow<Real>(from, rod.radius), colliderRow<Real>(line, 1 / length2(line))}};
}

template <class Real>
ColliderRows<Real> rowsOf(const MeshShape& shape) {
    const DistanceNodes& nodes = shape.mesh->nodes;
    const NodeCounts& n = nodes.count;
    const double step = shape.scale * nodes.step;
    const Double3 size{(n.x - 1) * step, (n.y - 1) * step, (n.z - 1) * step};
    const Vec3<double> middle{shape.scale * nodes.origin.x + size.x / 2,
                              shape.scale * nodes.origin.y + size.y / 2,
                              shape.scale * nodes.origin.z + size.z / 2};
    const Quaternion& r = shape.rotation;
    const Vec3<double> turned = rotate(normalized(Quat<double>{r.x, r.y, r.z, r.w}), middle);
    const Double3& at = shape.position;
    const double margin = shape.scale * nodes.margin;
    const Double3 inner{size.x - 2 * margin, size.y - 2 * margin, size.z - 2 * margin};
    auto rows = rowsOf<Real>(Box{inner, {at.x + turned.x, at.y + turned.y, at.z + turned.z}, r});
    rows.shape = ColliderShape::kMesh;
    rows.row[3].w = static_cast<Real>(step);
    rows.counts = packedCounts(n);
    rows.margin = static_cast<Real>(margin);
    rows.per_step = Real(1) / rows.row[3].w;
    rows.steps = {nodes.steps.data(), nodes.steps.size()};
    return rows;
}

/// Of all meshes, one after the other: what a GPU needs of them.
inline std::vector<float> meshSteps(const std::vector<Collider>& colliders) {
    std::vector<float> steps;
    for (const Collider& collider : colliders)
        if (const auto* shape = std::get_if<MeshShape>(&collider.shape))
            steps.insert(steps.end(), shape->mesh->nodes.steps.begin(), shape->mesh->nodes.steps.end());
    return steps;
}

/// At most kMaxColliders. `steps`: meshSteps() on the device that will read them; none: the meshes' own.
template <class Real>
ColliderSet<Real> makeColliderSet(const std::vector<Collider>& colliders, Span<const float> steps = {}) {
    ColliderSet<Real> set;
    size_t used = 0;
    for (const Collider& collider : colliders) {
        ColliderRows<Real>& rows = set.collider[set.count++];
        rows = std::visit([](const auto& shape) { return rowsOf<Real>(shape); }, collider.shape);
        if (steps.empty()) continue;
        rows.steps = steps.part(used, rows.steps.size());
        used += rows.steps.size();
    }
    return set;
}

}  // namespace demolish
