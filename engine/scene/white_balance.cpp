// SPDX-License-Identifier: Apache-2.0
// The Planckian locus by cubics (Kang et al. 2002), each channel scaled (von Kries).
#include "engine/scene/white_balance.h"

#include <algorithm>

namespace demolish::engine {
namespace {

/// Chromaticity of a black body.
glm::vec2 blackBody(float temperature) {
    const float t = 1000 / std::clamp(temperature, kLeastTemperature, kMostTemperature);
    const bool is_warm = temperature <= 4000;
    const float x = is_warm ? ((-0.2661239f * t - 0.2343589f) * t + 0.8776956f) * t + 0.179910f
                            : ((-3.0258469f * t + 2.1070379f) * t + 0.2226347f) * t + 0.240390f;
    const float y = temperature <= 2222
                        ? ((-1.1063814f * x - 1.34811020f) * x + 2.18555832f) * x - 0.20219683f
                    : is_warm ? ((-0.9549476f * x - 1.37418593f) * x + 2.09137015f) * x - 0.16748867f
                              : ((3.0817580f * x - 5.87338670f) * x + 3.75112997f) * x - 0.37001483f;
    return {x, y};
}

glm::vec3 linearSrgb(glm::vec2 xy) {
    const glm::vec3 xyz(xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y);
    return {glm::dot(xyz, glm::vec3(3.2404542f, -1.5371385f, -0.4985314f)),
            glm::dot(xyz, glm::vec3(-0.9692660f, 1.8760108f, 0.0415560f)),
            glm::dot(xyz, glm::vec3(0.0556434f, -0.2040259f, 1.0572252f))};
}

}  // namespace

glm::vec3 whiteBalance(float temperature) {
    constexpr float kDarkest = 0.02f;  // of a channel: candles have hardly any blue
    const glm::vec3 daylight = linearSrgb(blackBody(kDaylight));
    const glm::vec3 light = glm::max(linearSrgb(blackBody(temperature)), glm::vec3(kDarkest));
    const glm::vec3 gains = daylight / light;
    return gains / glm::dot(gains, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace demolish::engine
