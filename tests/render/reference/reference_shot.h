// SPDX-License-Identifier: Apache-2.0
// A frame of a shot, drawn by us and written for a path tracer.
#pragma once
#include <filesystem>

#include "app/bridge/host_frame.h"
#include "app/commands/shot_options.h"
#include "engine/image/image.h"
#include "engine/scene/frame_view.h"

namespace demolish::reference {

/// What both sides draw: no grit, no dust, no tone curve.
struct ReferenceShot {
    HostFrame frame;
    engine::FrameView view;
    engine::Image ours;
};

/// Simulates up to `at` s on the CPU and draws that frame headless. Throws what the program's commands throw.
ReferenceShot takeShot(const ShotOptions& options, double at, PictureSize size);

/// Into `folder`, which is made: pieces.obj (an object a piece, usemtl outside and inside, z up),
/// surroundings.exr (longitude across), scene.json (camera, sun, floor, looks, balls) and ours.png. Throws
/// std::runtime_error where a file cannot be written.
void writeShot(const ReferenceShot& shot, const std::filesystem::path& folder);

/// Is Blender there?
bool hasBlender();

/// Runs cycles.py on such a folder. `samples` a pixel. Throws std::runtime_error where it makes no picture.
engine::Image pathTraced(const std::filesystem::path& folder, int samples);

}  // namespace demolish::reference
