// SPDX-License-Identifier: Apache-2.0
// body = [...] of a scene file: places, motion, and what a body has of its own.
#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <set>

#include "app/session/model_shot.h"
#include "app/session/scene_anchors.h"
#include "app/session/scene_assets.h"
#include "app/session/scene_parts_file.h"
#include "app/session/scene_shapes.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMostBodies = 1000;
constexpr Range kDegrees{-360, 360};
constexpr Range kSpeed{-200, 200};   // m/s, each coordinate
constexpr Range kSpin{-1000, 1000};  // rad/s, each coordinate

void readPlace(TomlReader& reader, const std::string& at, double height, SceneBody& body) {
    Double3 metres, degrees;
    reader.read(at + "position_m", metres, kPlaceRange);
    body.position = fromGlm(toGlm(metres) / height);
    double yaw = 0;
    reader.read(at + "yaw_deg", yaw, kDegrees);
    body.yaw = yaw * kDegree;
    if (reader.has(at + "rotation_deg")) {
        reader.read(at + "rotation_deg", degrees, kDegrees);
        const glm::dquat turn(kDegree * toGlm(degrees));  // about x, then y, then z
        body.turn = {turn.x, turn.y, turn.z, turn.w};
    }
    reader.read(at + "velocity_mps", body.velocity, kSpeed);
    reader.read(at + "spin_radps", body.spin, kSpin);
}

void readFineness(TomlReader& reader, const std::string& at, const Fineness& usual, SceneBody& body) {
    const bool by_size = reader.has(at + "particle_size_m"), by_number = reader.has(at + "particles");
    if (by_size && by_number)
        reader.fail(at + "particle_size_m", "and particles exclude each other: one follows from the other");
    if (by_size) {
        body.particle_size = OwnSize{0, usual.full};
        reader.read(at + "particle_size_m", body.particle_size->metres, kParticleSizeRange);
    }
    uint32_t particles = usual.full;
    reader.read(at + "particles", particles, {kMinParticles, kMaxParticles});
    body.particles_share = static_cast<double>(particles) / usual.full;
}

/// A body's own unit asks for the size of its file, even where the scene has a height.
void readSize(TomlReader& reader, const std::string& at, const Shot& shot, SceneBody& body) {
    const bool has_unit = reader.has(at + "unit"), has_height = reader.has(at + "height_m");
    if (has_unit && has_height)
        reader.fail(at + "height_m", "and unit exclude each other: one scales the model, the other keeps it");
    const bool all_have_height = reader.has("height_m");
    double height = all_have_height ? shot.height : 1;
    reader.read(at + "height_m", height, kHeightRange);
    body.keeps_size = has_unit || (!has_height && !all_have_height &&
                                   hasKnownSize(body.model.value_or(shot.model), partOf(shot, body)));
    if (body.keeps_size) height = all_have_height ? 1 : shot.height;  // the scene's `scale`
    body.height_share = height / shot.height;
}

OwnMaterial ofShot(const Shot& shot) {
    return {shot.material_name, shot.material, shot.look, shot.inner_material};
}

void readOwn(TomlReader& reader, const std::string& at, const Shot& shot, SceneBody& body) {
    if (reader.has(at + "model")) body.model = readModelPath(reader, at + "model");
    if (!body.model && shot.model.empty())
        reader.fail(at + "model", "is missing, and the scene names none for its bodies");
    ModelPart part = partOf(shot, body);
    readPart(reader, at, body.model.value_or(shot.model), part);
    if (part != partOf(shot, body)) body.part = part;
    readSize(reader, at, shot, body);
    if (reader.has(at + "material")) body.material = readOwnMaterial(reader, at + "material");
    if (reader.has(at + "inner_material")) {
        if (!body.material) body.material = ofShot(shot);
        readInside(reader, at + "inner_material", *body.material);
    }
    reader.read(at + "hidden", body.hidden);
    reader.read(at + "locked", body.locked);
    reader.read(at + "breaks", body.breaks);
    reader.read(at + "mortar", body.in_mortar);
    readFineness(reader, at, shot.fineness, body);
}

void readHold(TomlReader& reader, const std::string& at, const Shot& shot, SceneBody& body) {
    body.anchors = readAnchors(reader, at, shot, body);
    body.path = readPath(reader, at, shot.height);
    if (body.path.keys.empty()) return;
    if (body.breaks) reader.fail(at + "path", "needs breaks = false: what follows a path stays whole");
    if (!body.anchors.empty())
        reader.fail(at + "anchor", "and path exclude each other: a path holds all of it");
    for (const char* key : {"velocity_mps", "spin_radps"})
        if (reader.has(at + key)) reader.fail(at + key, "and path exclude each other");
}

void readCable(TomlReader& reader, const std::string& at, double height, SceneBody& body) {
    if (!reader.has(at + "cable")) return;
    if (body.path.keys.empty()) reader.fail(at + "cable", "needs a path: it hangs on what is led along one");
    requireKey(reader, at + "cable.to_m");
    Double3 from, to;
    double radius = 0.01;
    reader.read(at + "cable.at_m", from, kPlaceRange);
    reader.read(at + "cable.to_m", to, kPlaceRange);
    reader.read(at + "cable.radius_m", radius, {1e-4, 10});
    body.cable = Cable{fromGlm(toGlm(from) / height), fromGlm(toGlm(to) / height), radius / height};
}

bool moves(const SceneBody& body) {
    return body.velocity != Double3{} || body.spin != Double3{};
}

void requireFewKinds(TomlReader& reader, const std::vector<SceneBody>& bodies) {
    std::set<std::filesystem::path> models;
    std::vector<const OwnMaterial*> materials;
    for (const SceneBody& body : bodies) {
        if (body.model) models.insert(*body.model);
        const auto& own = body.material;
        if (own && std::none_of(materials.begin(), materials.end(),
                                [&](const OwnMaterial* known) { return *known == *own; }))
            materials.push_back(&*own);
    }
    if (models.size() > kMaxModels)
        reader.fail("body", "names " + std::to_string(models.size()) + " models; at most " +
                                std::to_string(kMaxModels) + " are possible");
    if (materials.size() >= kMaxMaterials)
        reader.fail("body", "names " + std::to_string(materials.size()) + " materials; at most " +
                                std::to_string(kMaxMaterials - 1) + " beside the scene's are possible");
}

}  // namespace

std::vector<SceneBody> readBodies(TomlReader& reader, const Shot& shot) {
    std::vector<SceneBody> bodies(reader.count("body", kMostBodies));
    for (size_t i = 0; i < bodies.size(); ++i) {
        const std::string at = "body[" + std::to_string(i) + "].";
        reader.read(at + "name", bodies[i].name);
        readPlace(reader, at, shot.height, bodies[i]);
        reader.read(at + "variant", bodies[i].variant, {0, static_cast<double>(bodies.size() - 1)});
        readOwn(reader, at, shot, bodies[i]);
        readHold(reader, at, shot, bodies[i]);
        readCable(reader, at, shot.height, bodies[i]);
        if (moves(bodies[i]) && shot.settle_time > 0)
            reader.fail(at + (bodies[i].velocity != Double3{} ? "velocity_mps" : "spin_radps"),
                        "needs solver.settle_s = 0: a body that moves would fall while the others settle");
    }
    requireFewKinds(reader, bodies);
    return bodies;
}

}  // namespace demolish
