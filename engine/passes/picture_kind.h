// SPDX-License-Identifier: Apache-2.0
// What shaders that light something are made for, so that none pays for what its pictures do not show.
#pragma once
#include <compare>
#include <string>

#include "engine/gl/program.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

struct PictureKind {
    int samples = 1;
    bool colliders = false, transparent = false, radiance = false;
    bool glass = false;  ///< transparent bodies tint the sun, and come over the picture
    bool glow = false;   ///< what model looks send out, or shade by a picture of occlusion
    bool looks = false;  ///< of models: for what is computed
    FloorMaterial floor = FloorMaterial::kChecker;
    ToneCurve tone = ToneCurve::kFilm;
    auto operator<=>(const PictureKind&) const = default;
};

/// `samples` are those of the targets, which the view may not get: they are left at 1.
PictureKind pictureKind(const FrameView& view, bool colliders);
/// As shaders/common/choices.glsl has the values.
std::string defines(const PictureKind& kind);
/// The tone curve's numbers, of a program with shaders/common/tone.glsl.
void setTone(gl::Program& program, ToneCurve curve);

}  // namespace demolish::engine
