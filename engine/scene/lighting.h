// SPDX-License-Identifier: Apache-2.0
// One sun and a sky.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

struct Lighting {
    glm::vec3 sun_direction{0.52f, -0.74f, -0.50f};  ///< the way the light travels; normalised on use
    glm::vec3 sun_colour{3.1f, 2.72f, 2.2f};  ///< what a white surface facing the sun shines with, linear
    glm::vec3 sky_zenith{0.20f, 0.42f, 0.80f};
    glm::vec3 sky_horizon{0.86f, 0.98f, 1.10f};
    glm::vec3 floor_colour{0.17f, 0.168f, 0.162f};
    float exposure = 0.85f;  ///< of everything, before the tone curve

    bool operator==(const Lighting&) const = default;
};

}  // namespace demolish::engine
