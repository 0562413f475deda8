// SPDX-License-Identifier: Apache-2.0
// A set becomes a text first: what a person may edit and what --split runs are one and the same.
#include "app/session/set_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/reading/model_reader.h"
#include "app/session/json_text.h"
#include "app/session/model_shot.h"
#include "app/session/scene_file.h"
#include "app/session/set_motion.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMostShine = 1000;  // as scene files take it
/// Of all bodies together, on GPU and CPU; and the most of one.
constexpr uint32_t kAllFull = 60000, kAllDraft = 6000, kMostFull = 10000, kMostDraft = 1200, kLeast = 60;

bool isCollider(const SetThing& thing) {
    return thing.node.starts_with(kColliderPrefix);
}
bool isAnchor(const SetThing& thing) {
    return thing.node.starts_with(kAnchorPrefix);
}
bool isBody(const SetThing& thing) {
    return !isCollider(thing) && !isAnchor(thing);
}

glm::dvec3 upright(const Double3& p, const SetFile& file) {
    const glm::dvec3 at = file.scale * file.metres * toGlm(p);
    return file.up == UpAxis::kY ? at : glm::dvec3(at.x, at.z, -at.y);
}

/// m, of the scene.
struct Extent {
    glm::dvec3 low, high;
    glm::dvec3 middle() const { return 0.5 * (low + high); }
};

Extent extentOf(const SetThing& thing, const SetFile& file) {
    const glm::dvec3 a = upright(thing.low, file), b = upright(thing.high, file);
    return {glm::min(a, b), glm::max(a, b)};
}

/// A basic string of TOML; JSON's is one.
std::string quoted(const std::string& text) {
    return jsonText(nlohmann::ordered_json(text), -1);
}

std::string vectorText(const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "[%.6g, %.6g, %.6g]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
    return text;
}

/// Its bodies. Where all of them move, none does: something has to break.
struct SetBodies {
    std::vector<const SetThing*> things;
    std::vector<Extent> extents;
    bool any_stands = false;

    SetBodies(const ModelSet& set, const SetFile& file) {
        for (const SetThing& thing : set.things) {
            if (!isBody(thing)) continue;
            things.push_back(&thing);
            extents.push_back(extentOf(thing, file));
            any_stands = any_stands || thing.motion.size() < 2;
        }
    }
    bool moves(size_t b) const { return any_stands && things[b]->motion.size() > 1; }
    size_t moving() const {
        size_t count = 0;
        for (size_t b = 0; b < things.size(); ++b) count += moves(b);
        return count;
    }
};

/// The point that position_m names: the middle of its foot as the file has it.
glm::dvec3 footOf(const Extent& extent) {
    return {extent.middle().x, extent.low.y, extent.middle().z};
}

std::vector<BodyPose> posesOf(const SetThing& thing, const Extent& extent, const SetFile& file) {
    std::vector<BodyPose> poses;
    for (const SetPose& pose : thing.motion) {
        glm::dvec3 axis(pose.turn.x, pose.turn.y, pose.turn.z);
        if (file.up == UpAxis::kZ) axis = {axis.x, axis.z, -axis.y};
        const glm::dquat turn(pose.turn.w, axis.x, axis.y, axis.z);
        poses.push_back(
            {pose.time, upright(pose.middle, file) + turn * (footOf(extent) - extent.middle()), turn});
    }
    return poses;
}

/// Round all bodies.
Extent extentOfBodies(const ModelSet& set, const SetFile& file) {
    Extent all{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const SetThing& thing : set.things) {
        if (!isBody(thing)) continue;
        const Extent own = extentOf(thing, file);
        all = {glm::min(all.low, own.low), glm::max(all.high, own.high)};
    }
    return all;
}

/// Where a ball hits a standing body: the one in the middle of the camera's picture; without a camera the
/// largest.
size_t bodyToHit(const SetBodies& set_bodies, const ModelSet& set, const SetFile& file) {
    const std::vector<Extent>& bodies = set_bodies.extents;
    const auto merit = [&](const Extent& body) {
        const glm::dvec3 size = body.high - body.low;
        if (!set.camera) return size.x * size.y * size.z;
        const glm::dvec3 eye = upright(set.camera->eye, file), target = upright(set.camera->target, file);
        return glm::dot(glm::normalize(body.middle() - eye), glm::normalize(target - eye));
    };
    size_t best = bodies.size();
    for (size_t b = 0; b < bodies.size(); ++b)
        if (!set_bodies.moves(b) && (best == bodies.size() || merit(bodies[b]) > merit(bodies[best])))
            best = b;
    return best;
}

std::string scaleText(const SetFile& file) {
    if (file.scale == 1) return "";
    char text[64];
    std::snprintf(text, sizeof text, "scale = %.9g\n", file.scale);
    return text;
}

/// Or the scene would be refused by a line that nobody wrote.
void requirePlace(const std::string& node, const glm::dvec3& place) {
    const double farthest = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
    if (farthest <= kPlaceRange.most) return;
    throw UsageError("the node '" + node + "' would lie " + plainNumber(farthest) + " m from the origin; " +
                     plainNumber(kPlaceRange.most) + " m are possible: choose a --unit or a --height");
}

std::string bodiesText(const SetBodies& bodies, const SetFile& file, double lift) {
    std::string text = "body = [\n";
    for (size_t b = 0; b < bodies.things.size(); ++b) {
        const SetThing& thing = *bodies.things[b];
        std::vector<BodyPose> poses = posesOf(thing, bodies.extents[b], file);
        if (poses.size() > 1 && !bodies.moves(b)) poses.clear();
        glm::dvec3 place = poses.empty() ? footOf(bodies.extents[b]) : poses.front().place;
        place.y += lift;
        requirePlace(thing.node, place);
        text += "  { name = " + quoted(thing.node) + ", node = " + quoted(thing.node) +
                ", position_m = " + vectorText(place) + (poses.empty() ? "" : motionText(poses)) + " },\n";
    }
    return text + "]\n";
}

std::string collidersText(const ModelSet& set, const SetFile& file, double lift) {
    std::string text;
    size_t count = 0;
    for (const SetThing& thing : set.things) {
        if (!isCollider(thing)) continue;
        ++count;
        text += "\n[[collider]]\nshape = \"mesh\"\nmodel = " + quoted(file.model) +
                "\nnode = " + quoted(thing.node) + "\n";
        if (file.up == UpAxis::kZ) text += "up = \"z\"\n";
        if (!file.unit.empty()) text += "unit = " + quoted(file.unit) + "\n";
        text += scaleText(file);
        if (lift > 0) text += "position_m = " + vectorText({0, lift, 0}) + "\n";
    }
    if (count >= kMaxColliders)
        throw UsageError("the set has " + std::to_string(count) + " nodes named " + kColliderPrefix +
                         "...; at most " + std::to_string(kMaxColliders - 1) +
                         " are possible: join them, or put them below one node of such a name");
    return text;
}

/// What lies in the box round such a node is held.
std::string anchorsText(const ModelSet& set, const SetFile& file, double lift) {
    constexpr double kThinnest = 0.001;  // m, as scene files take it
    std::string text;
    for (const SetThing& thing : set.things) {
        if (!isAnchor(thing)) continue;
        const Extent extent = extentOf(thing, file);
        text += "\n[[anchor]]\nshape = \"box\"\nsize_m = " +
                vectorText(glm::max(extent.high - extent.low, glm::dvec3(kThinnest))) +
                "\nposition_m = " + vectorText(extent.middle() + glm::dvec3(0, lift, 0)) + "\n";
    }
    return text;
}

/// Where a camera is at a time, m.
struct Looking {
    glm::dvec3 eye, way, up;

    Looking(const Double3& from, const Double3& target, const Double3& up_there, const SetFile& file)
        : eye(upright(from, file)),
          way(glm::normalize(upright(target, file) - eye)),
          up(glm::normalize(upright(up_there, file))) {}
    /// As cameras stand that nobody has rolled.
    bool isLevel() const {
        constexpr double kRoll = 1e-3;  // rad
        const glm::dvec3 right = glm::cross(way, glm::dvec3(0, 1, 0));
        return up.y > 0 && std::abs(glm::dot(right, up)) <= kRoll * glm::length(right);
    }
};

bool isLevel(const SetCamera& camera, const SetFile& file) {
    return Looking(camera.eye, camera.target, camera.up, file).isLevel() &&
           std::all_of(camera.path.begin(), camera.path.end(), [&](const SetCameraKey& key) {
               return Looking(key.eye, key.target, key.up, file).isLevel();
           });
}

/// The target is 1 m from the eye, in whatever unit the file is.
std::string lookText(const Looking& look, bool with_up, double lift, const char* between) {
    const glm::dvec3 from = look.eye + glm::dvec3(0, lift, 0);
    std::string text = "eye_m = " + vectorText(from) + between + "target_m = " + vectorText(from + look.way);
    if (with_up) text += between + ("up = " + vectorText(look.up));
    return text;
}

std::string pathText(const SetCamera& camera, bool with_up, const SetFile& file, double lift) {
    if (camera.path.empty()) return "";
    std::string text = "path = [\n";
    for (const SetCameraKey& key : camera.path) {
        char time[48];
        std::snprintf(time, sizeof time, "  { at_s = %.9g, ", key.time);
        const Looking look(key.eye, key.target, key.up, file);
        text += time + lookText(look, with_up, lift, ", ") + " },\n";
    }
    return text + "]\n";
}

std::string cameraText(const SetCamera& camera, const SetFile& file, double lift) {
    char angle[64];
    std::snprintf(angle, sizeof angle, "field_of_view_deg = %.6g\n",
                  std::clamp(camera.field_of_view / kDegree, 5.0, 120.0));
    const bool with_up = !isLevel(camera, file);
    const Looking look(camera.eye, camera.target, camera.up, file);
    return "\n[camera]\n" + lookText(look, with_up, lift, "\n") + "\n" + angle +
           pathText(camera, with_up, file, lift);
}

/// What a white surface that faces the sun shines with. Of light that is as strong as a day's in lux, 683 are
/// a watt on a square metre; what is weaker is no daylight in lux, but in watts, as files without a unit
/// have it.
glm::dvec3 shineOf(const SetSun& sun) {
    constexpr double kLuxOfAWatt = 683, kLeastDaylight = 50;
    const glm::dvec3 colour = toGlm(sun.colour);
    const double most = std::max({colour.x, colour.y, colour.z});
    const glm::dvec3 watts = most > kLeastDaylight ? colour / kLuxOfAWatt : colour;
    return glm::min(watts / std::numbers::pi, glm::dvec3(kMostShine));
}

std::string lightText(const SetSun& sun, UpAxis up) {
    return "\n[light]\nsun_direction = " + vectorText(upright(sun.direction, {"", up, "", 1, 1})) +
           "\nsun_colour = " + vectorText(shineOf(sun)) + "\n";
}

/// What moves takes the ball's place.
std::string impactText(const SetBodies& bodies, const ModelSet& set, const SetFile& file) {
    const std::string body = "\nbody = " + std::to_string(bodyToHit(bodies, set, file)) + "\n";
    if (bodies.moving() > 0) return "\n[impact]\nvelocity_mps = 0" + body;
    std::string text = "\n[impact]\ntimes_threshold = " + plainNumber(kModelTimesThreshold) + body;
    if (!set.camera) return text;
    glm::dvec3 way = upright(set.camera->target, file) - upright(set.camera->eye, file);
    way.y = 0;  // level, as balls fly
    if (glm::length(way) > 0.1) text += "direction = " + vectorText(glm::normalize(way)) + "\n";
    return text;
}

std::string particlesText(size_t bodies) {
    const auto each = [bodies](uint32_t all, uint32_t most) {
        return std::to_string(std::clamp(all / static_cast<uint32_t>(bodies), kLeast, most));
    };
    return "\n[particles]\nfull = " + each(kAllFull, kMostFull) + "\ndraft = " + each(kAllDraft, kMostDraft) +
           "\n";
}

/// A set of colliders alone has no height, and is refused for that.
void requireScale(double scale, double height) {
    if (scale >= kSetScaleRange.least && scale <= kSetScaleRange.most) return;
    if (!(scale > 0)) return;
    throw UsageError("--height " + plainNumber(height) + " would make the set " + plainNumber(scale) +
                     " times as large as its file says; between " + plainNumber(kSetScaleRange.least) +
                     " and " + plainNumber(kSetScaleRange.most) + " times are possible");
}

}  // namespace

std::string sceneTextOf(const ModelSet& set, const SetFile& file) {
    const SetBodies bodies(set, file);
    if (bodies.things.empty())
        throw UsageError("the set holds colliders and anchors only, and nothing that could break");
    if (bodies.moving() > kMaxPaths)
        throw UsageError("the set has " + std::to_string(bodies.moving()) +
                         " nodes that its animations move; at most " + std::to_string(kMaxPaths) +
                         " are possible: join them, or export it without animations");
    const double lift = std::max(0.0, -extentOfBodies(set, file).low.y);
    std::string text =
        "# A scene of Demolish; keys: docs/file_keys.md\nversion = 1\nmodel = " + quoted(file.model) + "\n";
    if (file.up == UpAxis::kZ) text += "up = \"z\"\n";
    if (!file.unit.empty()) text += "unit = " + quoted(file.unit) + "\n";
    text += scaleText(file) + "material_preset = \"ceramic\"\n" + bodiesText(bodies, file, lift) +
            impactText(bodies, set, file) + particlesText(bodies.things.size());
    if (set.camera) text += cameraText(*set.camera, file, lift);
    if (set.sun) text += lightText(*set.sun, file.up);
    return text + collidersText(set, file, lift) + anchorsText(set, file, lift);
}

std::string sceneTextOf(const std::filesystem::path& model, const SetSize& size,
                        const std::filesystem::path& scene_file) {
    const bool is_known = hasKnownSize(model, size.part);
    if (!is_known && !size.height)
        throw UsageError("a set must be as large as it is meant, and the format of '" +
                         model.filename().string() + "' does not say its unit: give --unit, or --height");
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::absolute(scene_file).parent_path();
    std::filesystem::path named = std::filesystem::relative(model, folder, error);
    if (error || named.empty()) named = std::filesystem::absolute(model);
    const double unit = size.part.unit > 0 ? size.part.unit : 1;
    SetFile file{named.generic_string(), size.part.up, lengthUnitName(is_known ? size.part.unit : unit),
                 unit};
    const ModelSet set = readModelSet(model);
    if (size.height) {
        const Extent all = extentOfBodies(set, file);
        file.scale = *size.height / sizeToScale(fromGlm(all.high - all.low));
        requireScale(file.scale, *size.height);
    }
    return sceneTextOf(set, file);
}

Shot splitShot(const std::filesystem::path& model, const SetSize& size) {
    return loadSceneText(sceneTextOf(model, size, model), model);
}

}  // namespace demolish
