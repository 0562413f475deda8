// SPDX-License-Identifier: Apache-2.0
// Regions are in the frame of who holds them: the scene's in the world, a body's in its own.
#include "app/session/scene_anchors.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

#include "app/session/asset_files.h"
#include "app/session/scene_node_box.h"
#include "app/session/scene_shapes.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMostAnchors = 256, kMostKeys = 1000;
constexpr Range kKeyTime{0, 1000};        // s
constexpr Range kKeyTurn{-36000, 36000};  // degrees

PathKey readKey(TomlReader& reader, const std::string& at, double height) {
    PathKey key;
    Double3 metres, degrees;
    requireKey(reader, at + "at_s");
    reader.read(at + "at_s", key.time, kKeyTime);
    reader.read(at + "position_m", metres, kPlaceRange);
    reader.read(at + "rotation_deg", degrees, kKeyTurn);
    key.way = scaled(metres, 1 / height);
    key.turn = scaled(degrees, kDegree);
    return key;
}

MotionPath scaled(MotionPath path, double by) {
    for (PathKey& key : path.keys) key.way = scaled(key.way, by);
    return path;
}
Anchor scaled(Anchor anchor, double by) {
    if (auto* box = std::get_if<Box>(&anchor.region)) *box = scaled(*box, by);
    if (auto* ball = std::get_if<Sphere>(&anchor.region)) *ball = scaled(*ball, by);
    anchor.path = scaled(anchor.path, by);
    return anchor;
}

Double3 middleOf(const Anchor& anchor) {
    if (const auto* box = std::get_if<Box>(&anchor.region)) return box->position;
    return std::get<Sphere>(anchor.region).position;
}

/// From the body's own frame to the world, m.
Anchor placed(Anchor anchor, const BodyInstance& body) {
    const glm::dquat turn(body.rotation.w, body.rotation.x, body.rotation.y, body.rotation.z);
    const auto place = [&](const Double3& at) { return fromGlm(toGlm(body.position) + turn * toGlm(at)); };
    if (auto* ball = std::get_if<Sphere>(&anchor.region)) ball->position = place(ball->position);
    if (auto* box = std::get_if<Box>(&anchor.region)) {
        const Quaternion& own = box->rotation;
        box->position = place(box->position);
        const glm::dquat turned = turn * glm::dquat(own.w, own.x, own.y, own.z);
        box->rotation = {turned.x, turned.y, turned.z, turned.w};
    }
    return anchor;
}

Box readNode(TomlReader& reader, const std::string& at, const Shot& shot, const SceneBody* own) {
    return own != nullptr ? readOwnNodeBox(reader, at, shot, *own) : readNodeBox(reader, at, shot.model);
}

Anchor readAnchor(TomlReader& reader, const std::string& at, const Shot& shot, const SceneBody* own) {
    Anchor anchor;
    std::string shape;
    requireKey(reader, at + "shape");
    reader.read(at + "shape", shape);
    if (shape == "box")
        anchor.region = readBox(reader, at);
    else if (shape == "sphere")
        anchor.region = readSphere(reader, at);
    else if (shape == "node")
        anchor.region = readNode(reader, at, shot, own);
    else
        reader.fail(at + "shape", "must be one of " + listed({"box", "node", "sphere"}));
    anchor = scaled(anchor, 1 / shot.height);
    anchor.path = readPath(reader, at, shot.height);
    return anchor;
}

}  // namespace

MotionPath readPath(TomlReader& reader, const std::string& at, double height) {
    MotionPath path;
    const size_t count = reader.count(at + "path", kMostKeys);
    double before = 0;
    for (size_t k = 0; k < count; ++k) {
        const std::string key = at + "path[" + std::to_string(k) + "].";
        path.keys.push_back(readKey(reader, key, height));
        if (!(path.keys[k].time > before))
            reader.fail(key + "at_s", k == 0 ? "must be above 0: a path begins at 0 s where its thing stands"
                                             : "must be later than that of the key before it");
        before = path.keys[k].time;
    }
    if (!reader.has(at + "path_motion")) return path;
    std::string motion;
    reader.read(at + "path_motion", motion);
    if (motion != "linear" && motion != "smooth")
        reader.fail(at + "path_motion", "must be \"linear\" or \"smooth\"");
    if (path.keys.empty()) reader.fail(at + "path_motion", "is of no use without a path");
    path.smooth = motion == "smooth";
    return path;
}

std::vector<Anchor> readAnchors(TomlReader& reader, const Shot& shot) {
    std::vector<Anchor> anchors;
    const size_t count = reader.count("anchor", kMostAnchors);
    const auto last_body = static_cast<double>(std::max<size_t>(1, shot.bodies.size()) - 1);
    for (size_t i = 0; i < count; ++i) {
        const std::string here = "anchor[" + std::to_string(i) + "].";
        anchors.push_back(readAnchor(reader, here, shot, nullptr));
        if (reader.has(here + "body")) reader.read(here + "body", anchors[i].body.emplace(), {0, last_body});
    }
    return anchors;
}

std::vector<Anchor> readAnchors(TomlReader& reader, const std::string& at, const Shot& shot,
                                const SceneBody& body) {
    std::vector<Anchor> anchors;
    const size_t count = reader.count(at + "anchor", kMostAnchors);
    for (size_t i = 0; i < count; ++i)
        anchors.push_back(readAnchor(reader, at + "anchor[" + std::to_string(i) + "].", shot, &body));
    return anchors;
}

std::vector<Anchor> anchorsOf(const Shot& shot, const std::vector<BodyInstance>& bodies) {
    std::vector<Anchor> anchors;
    for (const Anchor& anchor : shot.anchors) {
        anchors.push_back(scaled(anchor, shot.height));
        anchors.back().pivot = middleOf(anchors.back());
    }
    const std::vector<SceneBody> places = bodiesOf(shot);
    for (uint32_t b = 0; b < places.size(); ++b) {
        for (const Anchor& own : places[b].anchors) {
            anchors.push_back(placed(scaled(own, shot.height), bodies.at(b)));
            anchors.back().body = b;
            anchors.back().pivot = middleOf(anchors.back());
        }
        if (places[b].path.keys.empty()) continue;
        Anchor whole;
        whole.body = b;
        whole.path = scaled(places[b].path, shot.height);
        whole.pivot = bodies.at(b).position;
        anchors.push_back(whole);
    }
    return anchors;
}

}  // namespace demolish
