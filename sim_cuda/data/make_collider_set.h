// SPDX-License-Identifier: Apache-2.0
// The colliders of a setup as kernels take them.
#pragma once
#include <variant>
#include <vector>

#include "sim_cuda/api/params.h"
#include "sim_cuda/data/colliders.h"

namespace demolish {

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
