// SPDX-License-Identifier: Apache-2.0
// A moving camera is looked at often, and what straight lines between fewer keys tell as well is left out.
#include "sim_cuda/authoring/camera_import.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/node_motion.h"

namespace demolish {
namespace {

constexpr size_t kMostLooks = kMostCameraKeys - 2, kLooksOfAKey = 16;
constexpr double kWayError = 1e-3;   // of how far the camera goes
constexpr double kTurnError = 1e-3;  // rad

struct CameraFrame {
    Double3 eye, way;
    double angle = 0;  ///< rad, of the picture's height
};

/// assimp keeps the angle across the picture; without an aspect of its own it is that of its height. Of glTF
/// it multiplies the angle of the height by the aspect, and repeats the node's place in the camera.
CameraFrame placed(const aiCamera& from, const NodeTransform& place, bool is_gltf) {
    const double across = double(from.mHorizontalFOV), aspect = from.mAspect > 0 ? double(from.mAspect) : 1;
    return {is_gltf ? place.origin : place.point(fromAssimp(from.mPosition)),
            normalized(place.direction(fromAssimp(from.mLookAt))),
            is_gltf ? across / aspect : 2 * std::atan(std::tan(0.5 * across) / aspect)};
}

bool isSound(const CameraFrame& frame) {
    return isFinite(frame.eye) && isFinite(frame.way) && frame.angle > 0;
}

SetCameraKey keyOf(double time, const CameraFrame& frame) {
    return {time, frame.eye, frame.eye + frame.way};
}

/// Between the file's keys as well: what turns about something goes in no straight line.
std::vector<double> looksAt(const std::vector<double>& times) {
    const size_t stride = (times.size() + kMostLooks - 1) / kMostLooks;
    const size_t each = std::clamp<size_t>(kMostLooks / times.size(), 1, kLooksOfAKey);
    std::vector<double> looks{0};
    for (size_t k = stride - 1; k < times.size(); k += stride) {
        const double from = looks.back();
        for (size_t i = 1; i <= each; ++i)
            looks.push_back(from + (times[k] - from) * double(i) / double(each));
    }
    if (looks.back() < times.back()) looks.push_back(times.back());
    return looks;
}

/// How far a straight line from key a to key b is from key `at`, 1: as far as it may be.
double errorOf(const SetCameraKey& a, const SetCameraKey& b, const SetCameraKey& at, double most_way) {
    const double share = (at.time - a.time) / (b.time - a.time);
    const Double3 eye = a.eye + (b.eye - a.eye) * share, target = a.target + (b.target - a.target) * share;
    return std::max(length(at.eye - eye) / most_way,
                    length((at.target - at.eye) - (target - eye)) / kTurnError);
}

/// Marks what is needed of the keys between two that are (Douglas and Peucker).
void markNeeded(const std::vector<SetCameraKey>& keys, double most_way, std::vector<bool>& needed) {
    std::vector<std::pair<size_t, size_t>> open{{0, keys.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        size_t worst = first;
        double error = 1;
        for (size_t k = first + 1; k < last; ++k)
            if (const double own = errorOf(keys[first], keys[last], keys[k], most_way); own > error) {
                error = own;
                worst = k;
            }
        if (worst == first) continue;
        needed[worst] = true;
        open.emplace_back(first, worst);
        open.emplace_back(worst, last);
    }
}

/// The first is that of 0 s.
std::vector<SetCameraKey> thinned(const std::vector<SetCameraKey>& keys) {
    double reach = 0;
    for (const SetCameraKey& key : keys) reach = std::max(reach, length(key.eye - keys[0].eye));
    std::vector<bool> needed(keys.size(), false);
    needed.front() = needed.back() = true;
    markNeeded(keys, std::max(kWayError * reach, 1e-9 * (1 + length(keys[0].eye))), needed);
    std::vector<SetCameraKey> kept;
    for (size_t k = 0; k < keys.size(); ++k)
        if (needed[k]) kept.push_back(keys[k]);
    if (kept.size() == 2 && kept[0].eye == kept[1].eye && kept[0].target == kept[1].target) kept.pop_back();
    return kept;
}

}  // namespace

std::optional<SetCamera> importCamera(const aiScene& scene, bool is_gltf) {
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera& from = *scene.mCameras[c];
        const aiNode* node = scene.mRootNode->FindNode(from.mName);
        if (node == nullptr) {
            const CameraFrame frame = placed(from, {}, is_gltf);
            if (isSound(frame)) return SetCamera{frame.eye, frame.eye + frame.way, frame.angle, {}};
            continue;
        }
        const NodeMotion motion(scene, *node);
        const CameraFrame start = placed(from, motion.at(0), is_gltf);
        if (!isSound(start)) continue;
        SetCamera camera{start.eye, start.eye + start.way, start.angle, {}};
        if (motion.times().empty()) return camera;
        std::vector<SetCameraKey> keys;
        for (const double time : looksAt(motion.times()))
            if (const CameraFrame frame = placed(from, motion.at(time), is_gltf); isSound(frame))
                keys.push_back(keyOf(time, frame));
        keys = thinned(keys);
        camera.path.assign(keys.begin() + 1, keys.end());
        return camera;
    }
    return std::nullopt;
}

}  // namespace demolish
