// SPDX-License-Identifier: Apache-2.0
// A moving camera is looked at often, and what straight lines between fewer keys tell as well is left out.
#include "sim_cuda/authoring/camera_import.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/key_thinning.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/node_motion.h"

namespace demolish {
namespace {

constexpr size_t kMostLooks = kMostCameraKeys - 2;
constexpr double kWayError = 1e-3;   // of how far the camera goes
constexpr double kTurnError = 1e-3;  // rad

struct CameraFrame {
    Double3 eye, way, up;
    double angle = 0;  ///< rad, of the picture's height
};

/// assimp keeps the angle across the picture; without an aspect of its own it is that of its height. Of glTF
/// it multiplies the angle of the height by the aspect, and repeats the node's place in the camera.
CameraFrame placed(const aiCamera& from, const NodeTransform& place, bool is_gltf) {
    const double across = double(from.mHorizontalFOV), aspect = from.mAspect > 0 ? double(from.mAspect) : 1;
    const Double3 way = normalized(place.direction(fromAssimp(from.mLookAt))),
                  up = place.direction(fromAssimp(from.mUp));
    return {is_gltf ? place.origin : place.point(fromAssimp(from.mPosition)), way,
            normalized(up - way * dot(way, up)),
            is_gltf ? across / aspect : 2 * std::atan(std::tan(0.5 * across) / aspect)};
}

bool isSound(const CameraFrame& frame) {
    return isFinite(frame.eye) && isFinite(frame.way) && isFinite(frame.up) && frame.angle > 0;
}

SetCameraKey keyOf(double time, const CameraFrame& frame) {
    return {time, frame.eye, frame.eye + frame.way, frame.up};
}

SetCamera cameraOf(const CameraFrame& frame) {
    return {frame.eye, frame.eye + frame.way, frame.up, frame.angle, {}};
}

bool isAlike(const SetCameraKey& a, const SetCameraKey& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up;
}

/// The first is that of 0 s.
std::vector<SetCameraKey> thinned(const std::vector<SetCameraKey>& keys) {
    double reach = 0;
    for (const SetCameraKey& key : keys) reach = std::max(reach, length(key.eye - keys[0].eye));
    const double most_way = std::max(kWayError * reach, 1e-9 * (1 + length(keys[0].eye)));
    std::vector<double> times;
    std::vector<std::vector<Double3>> vectors;
    for (const SetCameraKey& key : keys) {
        times.push_back(key.time);
        vectors.push_back(
            {key.eye * (1 / most_way), (key.target - key.eye) * (1 / kTurnError), key.up * (1 / kTurnError)});
    }
    std::vector<SetCameraKey> kept;
    for (const size_t k : neededMoments(times, vectors)) kept.push_back(keys[k]);
    if (kept.size() == 2 && isAlike(kept[0], kept[1])) kept.pop_back();
    return kept;
}

}  // namespace

std::optional<SetCamera> importCamera(const aiScene& scene, bool is_gltf) {
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera& from = *scene.mCameras[c];
        const aiNode* node = scene.mRootNode->FindNode(from.mName);
        if (node == nullptr) {
            const CameraFrame frame = placed(from, {}, is_gltf);
            if (isSound(frame)) return cameraOf(frame);
            continue;
        }
        const NodeMotion motion(scene, *node);
        const CameraFrame start = placed(from, motion.at(0), is_gltf);
        if (!isSound(start)) continue;
        SetCamera camera = cameraOf(start);
        if (motion.times().empty()) return camera;
        std::vector<SetCameraKey> keys;
        for (const double time : looksAt(motion.times(), kMostLooks))
            if (const CameraFrame frame = placed(from, motion.at(time), is_gltf); isSound(frame))
                keys.push_back(keyOf(time, frame));
        keys = thinned(keys);
        camera.path.assign(keys.begin() + 1, keys.end());
        return camera;
    }
    return std::nullopt;
}

}  // namespace demolish
