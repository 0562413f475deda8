// SPDX-License-Identifier: Apache-2.0
// The way of a camera through a shot.
#pragma once
#include <vector>

#include "engine/scene/camera.h"

namespace demolish {

/// Where the camera is at a time, and how wide it looks.
struct CameraKey {
    double time = 0;              ///< s, above 0
    glm::vec3 eye{0}, target{0};  ///< m
    glm::vec3 up{0, 1, 0};        ///< as Camera's
    float field_of_view = 0.7f;   ///< likewise
    bool operator==(const CameraKey&) const = default;
};

/// Where a path that begins there is at 0 s.
CameraKey startKey(const engine::Camera& start);

/// `start` moved along a path that it stands at the beginning of, at 0 s: eye, target, up and field of view
/// go in a straight line from key to key, by ascending time, and stay at the last one. Without keys it
/// stands.
engine::Camera cameraAt(const engine::Camera& start, const std::vector<CameraKey>& path, double time);

}  // namespace demolish
