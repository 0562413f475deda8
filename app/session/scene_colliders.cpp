// SPDX-License-Identifier: Apache-2.0
// A shape more: what reads it, and an overload each of scaled() and drawn().
#include "app/session/scene_colliders.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "app/reading/model_reader.h"
#include "app/session/asset_files.h"
#include "app/session/mean_colour.h"
#include "app/session/scene_node_box.h"
#include "app/session/scene_shapes.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kEdgeRange{1e-3, 1e4};  // m, radii as well
constexpr Range kFrictionRange{0, 1.5}, kRestitutionRange{0.05, 1};
/// Of a plane, in radii of the scene: how far it is drawn beyond the place nearest to the scene, and how
/// deep.
constexpr double kPlaneReach = 3, kPlaneDepth = 0.1;

Collider readPlane(TomlReader& reader, const std::string& at) {
    Double3 position, normal{0, 1, 0};
    reader.read(at + "position_m", position, kPlaceRange);
    reader.read(at + "normal", normal, kDirectionRange);
    const double length = glm::length(toGlm(normal));
    if (!(length > 1e-9)) reader.fail(at + "normal", "must not be zero");
    const glm::dvec3 unit = toGlm(normal) / length;
    return Plane{fromGlm(unit), glm::dot(unit, toGlm(position))};
}

Collider readCapsule(TomlReader& reader, const std::string& at) {
    Capsule rod;
    for (const char* key : {"radius_m", "from_m", "to_m"}) requireKey(reader, at + key);
    reader.read(at + "radius_m", rod.radius, kEdgeRange);
    reader.read(at + "from_m", rod.from, kPlaceRange);
    reader.read(at + "to_m", rod.to, kPlaceRange);
    if (!(glm::distance(toGlm(rod.from), toGlm(rod.to)) >= kEdgeRange.least))
        reader.fail(at + "to_m", "must be at least 0.001 m from from_m; use a sphere instead");
    return rod;
}

/// The model is read and measured here, so that whatever is wrong with it is said with file, line and key.
/// Its colour is the file's.
Collider readMesh(TomlReader& reader, const std::string& at) {
    MeshShape shape;
    ColliderMeshOptions options;
    const PlacedNode node = readPlacedNode(reader, at, {});
    shape.scale = node.scale;
    shape.position = node.position;
    shape.rotation = node.rotation;
    reader.read(at + "cells", options.cells, {kLeastCells, kMostCells});
    options.up = node.part.up;
    try {
        const ImportedModel model = readModel(node.file, node.part.node);
        shape.mesh = makeColliderMesh(model.mesh, node.file, options);
        Collider collider = shape;
        collider.colour = meanColour(model);
        return collider;
    } catch (const InputFileError& error) {
        reader.fail(at + "model", std::string("is wrong: ") + error.what());
    }
}

const std::map<std::string, Collider (*)(TomlReader&, const std::string&)> kReaders{
    {"plane", readPlane},
    {"box", [](TomlReader& reader, const std::string& at) -> Collider { return readBox(reader, at); }},
    {"sphere", [](TomlReader& reader, const std::string& at) -> Collider { return readSphere(reader, at); }},
    {"capsule", readCapsule},
    {"mesh", readMesh}};

Plane scaled(const Plane& plane, double by) {
    return {plane.normal, by * plane.offset};
}
Capsule scaled(const Capsule& rod, double by) {
    return {by * rod.radius, scaled(rod.from, by), scaled(rod.to, by)};
}
MeshShape scaled(const MeshShape& shape, double by) {
    return {shape.mesh, by * shape.scale, scaled(shape.position, by), shape.rotation};
}
Collider scaled(Collider collider, double by) {
    std::visit([by](auto& shape) { shape = scaled(shape, by); }, collider.shape);
    return collider;
}

/// Turns z to a unit vector.
glm::quat facing(const glm::dvec3& z) {
    return glm::quatLookAt(-z, std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0));
}

engine::ColliderDraw drawn(const Plane& plane, const SceneSight& sight) {
    const glm::dvec3 normal = toGlm(plane.normal), centre = toGlm(sight.centre);
    const double distance = glm::dot(normal, centre) - plane.offset, depth = kPlaneDepth * sight.radius;
    const double reach = kPlaneReach * sight.radius + std::abs(distance);
    return {engine::ColliderShape::kPlane, glm::vec3(centre - (distance + 0.5 * depth) * normal),
            facing(normal), glm::vec3(reach, reach, 0.5 * depth), nullptr};
}
engine::ColliderDraw drawn(const Box& box, const SceneSight&) {
    const Quaternion& q = box.rotation;
    return {engine::ColliderShape::kBox, glm::vec3(toGlm(box.position)),
            glm::quat(glm::dquat(q.w, q.x, q.y, q.z)), glm::vec3(0.5 * toGlm(box.size)), nullptr};
}
engine::ColliderDraw drawn(const Sphere& ball, const SceneSight&) {
    return {engine::ColliderShape::kSphere, glm::vec3(toGlm(ball.position)), glm::quat(1, 0, 0, 0),
            glm::vec3(static_cast<float>(ball.radius)), nullptr};
}
engine::ColliderDraw drawn(const Capsule& rod, const SceneSight&) {
    const glm::dvec3 from = toGlm(rod.from), line = toGlm(rod.to) - from;
    const double length = glm::length(line);
    return {engine::ColliderShape::kCapsule, glm::vec3(from + 0.5 * line), facing(line / length),
            glm::vec3(rod.radius, rod.radius, rod.radius + 0.5 * length), nullptr};
}

engine::ColliderDraw drawn(const MeshShape& shape, const SceneSight&) {
    const Quaternion& q = shape.rotation;
    engine::ColliderDraw draw;
    draw.position = glm::vec3(toGlm(shape.position));
    draw.rotation = glm::quat(glm::dquat(q.w, q.x, q.y, q.z));
    draw.half_size = glm::vec3(static_cast<float>(shape.scale));
    draw.triangles = {shape.mesh, &shape.mesh->corners};
    return draw;
}

Collider readCollider(TomlReader& reader, const std::string& at) {
    std::string shape;
    requireKey(reader, at + "shape");
    reader.read(at + "shape", shape);
    std::vector<std::string> known;
    for (const auto& [name, read] : kReaders) known.push_back(name);
    if (!kReaders.contains(shape)) reader.fail(at + "shape", "must be one of " + listed(known));
    Collider collider = kReaders.at(shape)(reader, at);
    if (reader.has(at + "friction"))
        reader.read(at + "friction", collider.friction.emplace(), kFrictionRange);
    if (reader.has(at + "restitution"))
        reader.read(at + "restitution", collider.restitution.emplace(), kRestitutionRange);
    if (reader.has(at + "colour")) {
        float rgb[3];
        reader.readColour(at + "colour", rgb);
        collider.colour = Float3{rgb[0], rgb[1], rgb[2]};
    }
    return collider;
}

}  // namespace

std::vector<Collider> readColliders(TomlReader& reader, double height) {
    std::vector<Collider> colliders;
    const size_t count = reader.count("collider", kMaxColliders - 1);  // and the floor
    for (size_t i = 0; i < count; ++i) {
        const std::string at = "collider[" + std::to_string(i) + "].";
        colliders.push_back(scaled(readCollider(reader, at), 1 / height));
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
    for (const Collider& collider : collidersOf(shot)) {
        if (collider == Collider{Plane{}}) continue;
        list.push_back(std::visit([&](const auto& shape) { return drawn(shape, sight); }, collider.shape));
        if (collider.colour)
            list.back().colour = glm::vec3(collider.colour->x, collider.colour->y, collider.colour->z);
    }
    return list;
}

}  // namespace demolish
