// SPDX-License-Identifier: Apache-2.0
#include "app/session/camera_path.h"

#include <algorithm>

namespace demolish {

CameraKey startKey(const engine::Camera& start) {
    return {0, start.eye, start.target, start.up, start.field_of_view};
}

engine::Camera cameraAt(const engine::Camera& start, const std::vector<CameraKey>& path, double time) {
    const auto next = std::upper_bound(path.begin(), path.end(), time,
                                       [](double t, const CameraKey& key) { return t < key.time; });
    const CameraKey before = next == path.begin() ? startKey(start) : *(next - 1);
    const CameraKey& after = next == path.end() ? before : *next;
    const double length = after.time - before.time;
    const auto share = static_cast<float>(length > 0 ? std::max(0.0, time - before.time) / length : 0);
    engine::Camera camera = start;
    camera.eye = glm::mix(before.eye, after.eye, share);
    camera.target = glm::mix(before.target, after.target, share);
    camera.up = glm::mix(before.up, after.up, share);
    camera.field_of_view = glm::mix(before.field_of_view, after.field_of_view, share);
    return camera;
}

}  // namespace demolish
