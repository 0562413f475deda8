// One sun and a sky.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

struct Lighting {
    glm::vec3 sun_direction{-0.45f, -0.75f, -0.48f};  ///< the way the light travels; normalised on use
    glm::vec3 sun_colour{3.2f, 3.0f, 2.7f};           ///< linear, times exposure
    glm::vec3 sky_zenith{0.32f, 0.47f, 0.72f};
    glm::vec3 sky_horizon{0.78f, 0.84f, 0.90f};
    glm::vec3 floor_colour{0.42f, 0.41f, 0.40f};
    float exposure = 0.9f;
};

}  // namespace demolish::engine
