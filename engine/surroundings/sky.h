// SPDX-License-Identifier: Apache-2.0
// A clear sky by scattering in the air, for any height of the sun.
#pragma once
#include "engine/surroundings/sun.h"

namespace demolish::engine {

struct ClearSky {
    RadiancePicture picture;  ///< without the sun; below the horizon lies grey ground
    Sun sun;
};

/// `to_sun`: unit; a sun below the horizon lights the air alone. Brightness is evened as a camera's exposure
/// would: kEvenBrightness.
ClearSky clearSky(glm::vec3 to_sun);

/// Mean radiance that a white surface sends out, over all ways that it may face, of each of our own
/// surroundings.
inline constexpr float kEvenBrightness = 1.3f;

}  // namespace demolish::engine
