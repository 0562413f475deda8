// SPDX-License-Identifier: Apache-2.0
// One sun in surroundings, the floor that they light, and how the camera takes the light.
#pragma once
#include <memory>

#include <glm/glm.hpp>

#include "engine/scene/tone_curve.h"
#include "engine/scene/white_balance.h"

namespace demolish::engine {

struct Surroundings;

/// kSweep: a studio's paper, which goes on into the background without a horizon. kShadow: not seen but for
/// the shadow that it catches.
enum class FloorMaterial { kChecker, kConcrete, kPlanks, kGrid, kSweep, kShadow, kNone };

struct Lighting {
    glm::vec3 sun_direction{0.52f, -0.74f, -0.50f};  ///< the way the light travels; normalised on use
    glm::vec3 sun_colour{3.1f, 2.72f, 2.2f};  ///< what a white surface facing the sun shines with, linear
    float sun_tangent = 0.035f;  ///< of its apparent radius; larger than the real sun's 0.0047, which would
                                 ///< look hard on a metre-sized body
    /// All light but the sun's; none: a clear sky, of the renderer's own.
    std::shared_ptr<const Surroundings> surroundings{};
    FloorMaterial floor = FloorMaterial::kChecker;
    glm::vec3 floor_colour{0.115f, 0.112f, 0.106f};
    float exposure = 0.85f;         ///< of everything, before the tone curve
    float temperature = kDaylight;  ///< K, of the light that is shown as white
    ToneCurve tone = ToneCurve::kFilm;

    bool operator==(const Lighting&) const = default;
};

}  // namespace demolish::engine
