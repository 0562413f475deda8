// SPDX-License-Identifier: Apache-2.0
// A shape more: what reads it, and an overload each of scaled() and drawn().
#include "app/session/scene_colliders.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr Range kEdgeRange{1e-3, 1e4};  // m
/// Of a plane, in radii of the scene: how far it is drawn beyond the place nearest to the scene, and how
/// deep.
constexpr double kPlaneReach = 3, kPlaneDepth = 0.1;

void require(TomlReader& reader, const std::string& path) {
    if (!reader.has(path)) reader.fail(path, "is missing");
}

Collider readPlane(TomlReader& reader, const std::string& at) {
    Double3 position, normal{0, 1, 0};
    reader.read(at + "position_m", position, kPlaceRange);
    reader.read(at + "normal", normal, kDirectionRange);
    const double length = glm::length(toGlm(normal));
    if (!(length > 1e-9)) reader.fail(at + "normal", "must not be zero");
    const glm::dvec3 unit = toGlm(normal) / length;
    return Plane{fromGlm(unit), glm::dot(unit, toGlm(position))};
}

Collider readBox(TomlReader& reader, const std::string& at) {
    Box box;
    Double3 degrees;
    require(reader, at + "size_m");
    reader.read(at + "size_m", box.size, kEdgeRange);
    reader.read(at + "position_m", box.position, kPlaceRange);
    reader.read(at + "rotation_deg", degrees, {-360, 360});
    const glm::dquat turn(kDegree * toGlm(degrees));  // about x, then y, then z
    box.rotation = {turn.x, turn.y, turn.z, turn.w};
    return box;
}

Double3 scaled(const Double3& lengths, double by) {
    return fromGlm(by * toGlm(lengths));
}
Collider scaled(const Plane& plane, double by) {
    return Plane{plane.normal, by * plane.offset};
}
Collider scaled(const Box& box, double by) {
    return Box{scaled(box.size, by), scaled(box.position, by), box.rotation};
}
Collider scaled(const Collider& collider, double by) {
    return std::visit([by](const auto& shape) { return scaled(shape, by); }, collider);
}

engine::ColliderDraw drawn(const Plane& plane, const SceneSight& sight) {
    const glm::dvec3 normal = toGlm(plane.normal), centre = toGlm(sight.centre);
    const double distance = glm::dot(normal, centre) - plane.offset, depth = kPlaneDepth * sight.radius;
    const double reach = kPlaneReach * sight.radius + std::abs(distance);
    const glm::dvec3 up = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    return {engine::ColliderShape::kPlane, glm::vec3(centre - (distance + 0.5 * depth) * normal),
            glm::quat(glm::quatLookAt(-normal, up)), glm::vec3(reach, reach, 0.5 * depth)};
}
engine::ColliderDraw drawn(const Box& box, const SceneSight&) {
    const Quaternion& q = box.rotation;
    return {engine::ColliderShape::kBox, glm::vec3(toGlm(box.position)),
            glm::quat(glm::dquat(q.w, q.x, q.y, q.z)), glm::vec3(0.5 * toGlm(box.size))};
}

}  // namespace

std::vector<Collider> readColliders(TomlReader& reader, double height) {
    std::vector<Collider> colliders;
    const size_t count = reader.count("collider", kMaxColliders - 1);  // and the floor
    for (size_t i = 0; i < count; ++i) {
        const std::string at = "collider[" + std::to_string(i) + "].";
        std::string shape;
        require(reader, at + "shape");
        reader.read(at + "shape", shape);
        if (shape != "plane" && shape != "box") reader.fail(at + "shape", "must be \"plane\" or \"box\"");
        colliders.push_back(scaled(shape == "box" ? readBox(reader, at) : readPlane(reader, at), 1 / height));
    }
    return colliders;
}

std::vector<Collider> collidersOf(const Shot& shot) {
    std::vector<Collider> colliders{Plane{}};
    for (const Collider& collider : shot.colliders) colliders.push_back(scaled(collider, shot.height));
    return colliders;
}

std::vector<engine::ColliderDraw> drawnColliders(const Shot& shot, const SceneSight& sight) {
    std::vector<engine::ColliderDraw> list;
    for (const Collider& collider : collidersOf(shot))
        if (collider != Collider{Plane{}})
            list.push_back(std::visit([&](const auto& shape) { return drawn(shape, sight); }, collider));
    return list;
}

}  // namespace demolish
