// SPDX-License-Identifier: Apache-2.0
// The shaders' side of these choices is preprocessor text.
#include "engine/passes/picture_kind.h"

#include "engine/scene/tone_curve.h"

namespace demolish::engine {
namespace {

constexpr GLint kCurve = 0, kCurveMore = 16;

}  // namespace

PictureKind pictureKind(const FrameView& view, bool colliders) {
    PictureKind kind;
    kind.colliders = colliders;
    kind.transparent = view.transparent;
    kind.radiance = view.radiance;
    kind.floor = view.lighting.floor;
    kind.tone = view.lighting.tone;
    return kind;
}

std::string defines(const PictureKind& kind) {
    std::string text = "#define SAMPLES " + std::to_string(kind.samples) + "\n#define FLOOR " +
                       std::to_string(static_cast<int>(kind.floor)) + "\n#define TONE " +
                       std::to_string(static_cast<int>(kind.tone)) + "\n#define PICTURE_FORMAT " +
                       (kind.radiance ? "rgba16f\n#define RADIANCE\n" : "rgba8\n");
    if (kind.colliders) text += "#define COLLIDERS\n";
    if (kind.transparent) text += "#define TRANSPARENT\n";
    if (kind.glass) text += "#define GLASS\n";
    if (kind.glow) text += "#define GLOW\n";
    if (kind.looks) text += "#define LOOKS\n";
    return text;
}

void setTone(gl::Program& program, ToneCurve curve) {
    const ToneParameters tone = toneParameters(curve);
    program.set(kCurve, tone.first);
    program.set(kCurveMore, tone.second);
}

}  // namespace demolish::engine
