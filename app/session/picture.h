// SPDX-License-Identifier: Apache-2.0
// From a shot's values and its bodies to what the renderer is asked to draw.
#pragma once
#include <string>

#include "app/session/shot_setup.h"
#include "engine/scene/frame_view.h"

namespace demolish {

/// The shot's camera after `time` s.
engine::Camera shotCamera(const Shot& shot, const BodyList& bodies, double time);

/// Camera at the start, light and looks of the shot; noise sized to the cells, shadow to all of the shot's
/// bodies.
engine::FrameView makeFrameView(const Shot& shot, const BodyList& bodies, int width, int height,
                                engine::RenderQuality quality);

/// Puts the shot's cables where they are after `time` s, as makeFrameView() has them at the start.
void hangCables(const Shot& shot, double time, engine::FrameView& view);

/// How light became colour in its pictures, for the files.
std::string colourNote(const Shot& shot, bool transparent);

}  // namespace demolish
