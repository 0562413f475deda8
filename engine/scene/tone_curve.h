// SPDX-License-Identifier: Apache-2.0
// From light to display, as shaders/common/tone.glsl does it.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

/// kFilm: contrast in the middle, a shoulder towards white. kAgx: as AgX does, a sigmoid of the logarithm
/// after saturated light has been mixed towards white, softer and paler. kNeutral: as it is up to 0.8, then
/// only as much as fits (Khronos PBR Neutral): colours of materials stay. kNone: cut off at 1.
enum class ToneCurve { kFilm, kAgx, kNeutral, kNone };

/// The numbers that the curve's shader takes. kFilm: contrast, shoulder, b, c. kAgx: slope, power, bend below
/// and above middle grey; then scale and offset of the logarithm, and where middle grey is shown.
struct ToneParameters {
    glm::vec4 first{0}, second{0};
};
ToneParameters toneParameters(ToneCurve curve);

/// Of grey light: what the display shows, linear, 0..1.
float toneOfGrey(ToneCurve curve, float light);

}  // namespace demolish::engine
