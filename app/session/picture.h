// SPDX-License-Identifier: Apache-2.0
// From a shot's values and its bodies to what the renderer is asked to draw.
#pragma once
#include <string>

#include "app/session/shot.h"
#include "engine/scene/frame_view.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

/// Camera, light and look of the shot; noise sized to the body, shadow to all of the shot's bodies. `body` is
/// any filling of them.
engine::FrameView makeFrameView(const Shot& shot, const BreakableBody& body, int width, int height,
                                engine::RenderQuality quality);

/// How light became colour in its pictures, for the files.
std::string colourNote(const Shot& shot, bool transparent);

}  // namespace demolish
