// SPDX-License-Identifier: Apache-2.0
// The way of a camera through a shot.
#pragma once
#include <vector>

#include "engine/scene/camera.h"

namespace demolish {

/// Where the camera is at a time.
struct CameraKey {
    double time = 0;              ///< s, above 0
    glm::vec3 eye{0}, target{0};  ///< m
    glm::vec3 up{0, 1, 0};        ///< as Camera's
    bool operator==(const CameraKey&) const = default;
};

/// `start` moved along a path that it stands at the beginning of, at 0 s: eye, target and up go in a straight
/// line from key to key, by ascending time, and stay at the last one. Without keys it stands.
engine::Camera cameraAt(const engine::Camera& start, const std::vector<CameraKey>& path, double time);

}  // namespace demolish
