// SPDX-License-Identifier: Apache-2.0
// The light that casts shadows, taken out of a picture of surroundings.
#pragma once
#include <optional>

#include "engine/surroundings/radiance_picture.h"

namespace demolish::engine {

struct Sun {
    glm::vec3 towards{0, 1, 0};  ///< unit
    glm::vec3 colour{0};         ///< what a white surface facing it shines with: its irradiance / pi
    float tangent = 0.035f;      ///< of its apparent radius
};

/// The brightest thing in the upper half of the picture, if it stands out: then its light leaves the picture,
/// where what surrounds it takes its place. Together they light a surface as the picture did.
std::optional<Sun> takeSun(RadiancePicture& picture);

}  // namespace demolish::engine
