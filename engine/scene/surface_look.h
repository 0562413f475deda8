// SPDX-License-Identifier: Apache-2.0
// How the body looks.
#pragma once

namespace demolish::engine {

/// Linear colours.
struct SurfaceLook {
    float exterior_colour[3] = {0.17f, 0.23f, 0.31f};
    float exterior_roughness = 0.35f;
    float interior_colour[3] = {0.60f, 0.47f, 0.34f};
    float interior_roughness = 0.9f;
    float dust_colour[3] = {0.66f, 0.59f, 0.5f};  ///< of dust in the air
    float noise_scale = 0.01f;                    ///< m, first wavelength of the shading noise (0.2 h)
    float noise_strength = 0.4f;                  ///< 0.3..0.5 (geometry.md 4a)
    float crack_width = 0.0015f;                  ///< m

    bool operator==(const SurfaceLook&) const = default;
};

}  // namespace demolish::engine
