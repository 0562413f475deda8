// SPDX-License-Identifier: Apache-2.0
// Keys of the window, as commands and view changes.
#pragma once
#include "app/panel/panel_context.h"
#include "engine/scene/camera.h"

namespace demolish {

struct CameraHome {
    engine::Camera shot_camera;  ///< key 0
    glm::vec3 centre{0};         ///< m, what F frames
    float radius = 1;            ///< m
};

void handleShortcuts(PanelContext& context, engine::Camera& camera, const CameraHome& home);

}  // namespace demolish
