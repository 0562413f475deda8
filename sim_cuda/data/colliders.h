// SPDX-License-Identifier: Apache-2.0
// Static rigid shapes: signed distance and outward normal of each at a point, and the one loop over them that
// contacts, predictions, lists and books share. All but meshes are convex: such a solid lies behind its
// tangent planes, so that what stays clear of one stays clear of the solid. A mesh lies in a box that does.
#pragma once
#include <variant>
#include <vector>

#include "sim_cuda/api/params.h"
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// What the rows of a collider say.
enum class ColliderShape : uint32_t { kPlane, kBox, kSphere, kCapsule, kMesh };

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
    ColliderShape shape = ColliderShape::kPlane;
    uint32_t counts = 0;      ///< of a mesh: packedCounts()
    Real margin{};            ///< m, of a mesh: by which its grid reaches beyond the box of the rows
    Span<const float> steps;  ///< of a mesh: DistanceNodes::steps
    /// Plane: (unit normal; offsetOf). Box: three times (unit axis; halfEdgeOf), then (centre in m; 0).
    /// Sphere: (centre in m; radiusOf). Capsule: (one end in m; radiusOf), (to the other end in m;
    /// shareOf). Mesh: a box about it; the last number is stepOf.
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

/// m, of a sphere or a capsule.
template <class Real>
DEM_FN Real radiusOf(const Vec4<Real>& centre) {
    return centre.w;
}
/// m, between nodes of a mesh's grid.
template <class Real>
DEM_FN Real stepOf(const Vec4<Real>& centre) {
    return centre.w;
}
/// 1/m^2, of a capsule: 1 over the square of its line.
template <class Real>
DEM_FN Real shareOf(const Vec4<Real>& line) {
    return line.w;
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

/// m^2, nearer to a sphere's centre any direction is as good.
inline constexpr double kAtCentre = 1e-24;

/// Of a ball about what is `from_centre` (m) away from the point.
template <class Real>
DEM_FN TangentPlane<Real> tangentOfBall(const Vec3<Real>& from_centre, Real radius, const Vec3<Real>& high,
                                        const Vec3<Real>& low) {
    const Real squared = length2(from_centre), inverse = inverseSqrt(squared);
    const Vec3<Real> normal =
        squared > Real(kAtCentre) ? inverse * from_centre : Vec3<Real>{Real(0), Real(1), Real(0)};
    const Real distance = squared * inverse - radius;
    return {withW(normal, (dot(normal, high) - distance) + dot(normal, low)), distance};
}
template <class Real>
DEM_FN TangentPlane<Real> tangentOfSphere(const Vec4<Real>& ball, const Vec3<Real>& high,
                                          const Vec3<Real>& low) {
    return tangentOfBall((high - xyz(ball)) + low, radiusOf(ball), high, low);
}
/// Of the ball about the nearest point of the capsule's line.
template <class Real>
DEM_FN TangentPlane<Real> tangentOfCapsule(const Vec4<Real> (&row)[4], const Vec3<Real>& high,
                                           const Vec3<Real>& low) {
    const Vec3<Real> from_end = (high - xyz(row[0])) + low;
    const Real along = clampTo(dot(from_end, xyz(row[1])) * shareOf(row[1]), Real(0), Real(1));
    return tangentOfBall(axpy(-along, xyz(row[1]), from_end), radiusOf(row[0]), high, low);
}

/// Of a mesh, 10 bits each.
DEM_FN uint32_t packedCounts(const NodeCounts& n) {
    return n.x | n.y << 10 | n.z << 20;
}

/// Where a point lies along one axis of a grid of `nodes` nodes; `at`: in steps from the first.
template <class Real>
struct NodePlace {
    uint32_t node = 0;  ///< the lower one
    Real share{};       ///< 0..1, on the way to the next
    Real beyond{};      ///< steps, outside the grid; 0 within
};
template <class Real>
DEM_FN NodePlace<Real> nodePlace(Real at, uint32_t nodes) {
    const Real inside = at > Real(0) ? minOf(at, Real(nodes - 1)) : Real(0);
    const uint32_t node = minOf(static_cast<uint32_t>(inside), nodes - 2);
    return {node, inside - Real(node), at - inside};
}

/// Trilinear in a cell of eight nodes: value and gradient, in steps.
template <class Real>
DEM_FN Vec4<Real> trilinear(const Span<const float>& steps, uint32_t first, uint32_t row, uint32_t layer,
                            const Vec3<Real>& share) {
    // Along x in each of the four rows, then along y in the two layers, then along z.
    Real value[4], slope[4];
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t at = first + (k & 1) * row + (k >> 1) * layer;
        const Real low = Real(steps[at]);
        slope[k] = Real(steps[at + 1]) - low;
        value[k] = madd(share.x, slope[k], low);
    }
    Real across[2], slope_x[2], slope_y[2];
    for (uint32_t k = 0; k < 2; ++k) {
        slope_y[k] = value[2 * k + 1] - value[2 * k];
        across[k] = madd(share.y, slope_y[k], value[2 * k]);
        slope_x[k] = madd(share.y, slope[2 * k + 1] - slope[2 * k], slope[2 * k]);
    }
    const Real slope_z = across[1] - across[0];
    return {madd(share.z, slope_x[1] - slope_x[0], slope_x[0]),
            madd(share.z, slope_y[1] - slope_y[0], slope_y[0]), slope_z, madd(share.z, slope_z, across[0])};
}

/// The interpolated distance changes by at most the root of 3 times the way.
template <class Real>
DEM_FN Real sureDistance(Real distance) {
    return distance > Real(0) ? Real(0.577) * distance : distance;
}

/// Where a point lies in a mesh's grid.
template <class Real>
struct GridPlace {
    NodePlace<Real> x, y, z;
    uint32_t row = 0, layer = 0;  ///< nodes from one row to the next, and from one layer
    uint32_t first = 0;           ///< the lowest of the eight nodes round it
};
template <class Real>
DEM_FN GridPlace<Real> gridPlace(const ColliderRows<Real>& rows, const Vec3<Real>& high,
                                 const Vec3<Real>& low) {
    const Real per_step = Real(1) / stepOf(rows.row[3]);
    const Vec3<Real> from_centre = (high - xyz(rows.row[3])) + low;
    const auto along = [&](const Vec4<Real>& axis) {
        return (dot(xyz(axis), from_centre) + (halfEdgeOf(axis) + rows.margin)) * per_step;
    };
    const uint32_t nx = rows.counts & 1023, ny = rows.counts >> 10 & 1023, nz = rows.counts >> 20;
    GridPlace<Real> at{nodePlace(along(rows.row[0]), nx),
                       nodePlace(along(rows.row[1]), ny),
                       nodePlace(along(rows.row[2]), nz),
                       nx,
                       nx * ny,
                       0};
    at.first = at.z.node * at.layer + at.y.node * nx + at.x.node;
    return at;
}

template <class Real>
DEM_FN bool isWithin(const GridPlace<Real>& at) {
    return at.x.beyond == Real(0) && at.y.beyond == Real(0) && at.z.beyond == Real(0);
}
/// Value and gradient, in steps.
template <class Real>
DEM_FN Vec4<Real> fieldAt(const ColliderRows<Real>& rows, const GridPlace<Real>& at) {
    return trilinear(rows.steps, at.first, at.row, at.layer, Vec3<Real>{at.x.share, at.y.share, at.z.share});
}

/// Steps by which the distance in a cell is less than at one of its nodes, at most: the diagonal, and what a
/// grid is inexact by.
inline constexpr double kNodeSlack = 2;

/// m, so far is a point from a mesh at least, by one number of the grid in place of eight; beyond the grid 0.
template <class Real>
DEM_APART Real leastDistanceToMesh(Handed<ColliderRows<Real>> rows, Handed<Vec3<Real>> high,
                                   Handed<Vec3<Real>> low) {
    const GridPlace<Real> at = gridPlace(rows, high, low);
    const Real steps = isWithin(at) ? Real(rows.steps[at.first]) - Real(kNodeSlack) : Real(0);
    return stepOf(rows.row[3]) * maxOf(steps, Real(0));
}

/// Within the grid the interpolated distance and the way in which it grows; beyond it, from the surface point
/// that is nearest as seen from the grid's rim. Apart: only what is near a mesh pays for it, also in
/// registers.
template <class Real>
DEM_APART TangentPlane<Real> tangentOfMesh(Handed<ColliderRows<Real>> rows, Handed<Vec3<Real>> high,
                                           Handed<Vec3<Real>> low) {
    const Real step = stepOf(rows.row[3]);
    const GridPlace<Real> at = gridPlace(rows, high, low);
    const Vec4<Real> field = fieldAt(rows, at);
    const Real steep = inverseSqrt(length2(xyz(field)));
    const Vec3<Real> uphill = steep > Real(0) ? steep * xyz(field) : Vec3<Real>{Real(0), Real(1), Real(0)};
    const Vec3<Real> beyond{at.x.beyond, at.y.beyond, at.z.beyond};
    const Vec3<Real> away = axpy(field.w, uphill, beyond);
    const Real squared = length2(away), inverse = inverseSqrt(squared);
    const bool is_beyond = length2(beyond) > Real(0);
    const Vec3<Real> own = is_beyond ? inverse * away : uphill;
    const Real distance = step * (is_beyond ? squared * inverse : field.w);
    const Vec3<Real> normal =
        axpy(own.x, xyz(rows.row[0]), axpy(own.y, xyz(rows.row[1]), own.z * xyz(rows.row[2])));
    return {withW(normal, (dot(normal, high) - distance) + dot(normal, low)), distance};
}

/// m, that of tangentOfMesh() to the last bit: most points near a mesh do not touch it, and need no normal.
template <class Real>
DEM_APART Real distanceToMesh(Handed<ColliderRows<Real>> rows, Handed<Vec3<Real>> high,
                              Handed<Vec3<Real>> low) {
    const GridPlace<Real> at = gridPlace(rows, high, low);
    return isWithin(at) ? stepOf(rows.row[3]) * fieldAt(rows, at).w : tangentOfMesh(rows, high, low).distance;
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
        if (rows.shape == ColliderShape::kSphere) return tangentOfSphere(rows.row[0], high, low);
        if (rows.shape == ColliderShape::kCapsule) return tangentOfCapsule(rows.row, high, low);
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
    return {ColliderShape::kPlane, 0, 0, {}, {colliderRow<Real>({n.x, n.y, n.z}, plane.offset)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Box& box) {
    const auto q = normalized(Quat<double>{box.rotation.x, box.rotation.y, box.rotation.z, box.rotation.w});
    const Double3 &size = box.size, &at = box.position;
    return {ColliderShape::kBox,
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
    return {ColliderShape::kSphere, 0, 0, {}, {colliderRow<Real>({at.x, at.y, at.z}, ball.radius)}};
}
template <class Real>
ColliderRows<Real> rowsOf(const Capsule& rod) {
    const Vec3<double> from{rod.from.x, rod.from.y, rod.from.z}, to{rod.to.x, rod.to.y, rod.to.z};
    const Vec3<double> line = to - from;
    return {ColliderShape::kCapsule,
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
