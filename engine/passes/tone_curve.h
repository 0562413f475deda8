// SPDX-License-Identifier: Apache-2.0
// The tone curve's numbers, for all passes that end in display colours (shaders/common/tone.glsl).
#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace demolish::engine {

/// y = x^a, then y / (y^d b + c): contrast a in the middle, shoulder d towards white; b and c follow from
/// where middle grey and white land (Lottes, "Advanced techniques and optimization of HDR color pipelines",
/// GDC 2016).
inline glm::vec4 toneCurve() {
    constexpr float kContrast = 1.36f, kShoulder = 0.97f, kWhite = 9.0f, kGreyIn = 0.18f, kGreyOut = 0.19f;
    const float grey = std::pow(kGreyIn, kContrast), grey_d = std::pow(kGreyIn, kContrast * kShoulder);
    const float white = std::pow(kWhite, kContrast), white_d = std::pow(kWhite, kContrast * kShoulder);
    const float b = (white * kGreyOut - grey) / ((white_d - grey_d) * kGreyOut);
    const float c = (white_d * grey - white * grey_d * kGreyOut) / ((white_d - grey_d) * kGreyOut);
    return {kContrast, kShoulder, b, c};
}

}  // namespace demolish::engine
