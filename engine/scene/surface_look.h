// SPDX-License-Identifier: Apache-2.0
// How the body looks.
#pragma once

namespace demolish::engine {

/// What runs through the solid: shaders/common/solid_texture.glsl.
enum class SolidTexture { kNone, kVeins, kLayers, kCrystals, kPebbles, kBricks, kGrains };

/// Linear colours.
struct SurfaceLook {
    float exterior_colour[3] = {0.17f, 0.23f, 0.31f};
    float exterior_roughness = 0.35f;
    float interior_colour[3] = {0.60f, 0.47f, 0.34f};
    float interior_roughness = 0.9f;
    float dust_colour[3] = {0.66f, 0.59f, 0.5f};  ///< of dust in the air
    float noise_scale = 0.01f;                    ///< m, first wavelength of the shading noise (0.2 h)
    float noise_strength = 0.4f;                  ///< 0.3..0.5 (geometry.md 4a)
    float relief_height = 0;      ///< m, of broken faces near the camera; 0: none. A material's is over the
                                  ///< spacing of cells, and so is the next
    float relief_size = 0.5f;     ///< m, > 0: its longest waves
    float crack_width = 0.0015f;  ///< m, of lines between pieces at most

    SolidTexture texture = SolidTexture::kNone;
    float texture_size = 0.05f;                    ///< m, > 0: of its pattern
    float texture_colour[3] = {0.5f, 0.5f, 0.5f};  ///< of its second colour: veins, stones, joints
    float texture_outside = 1;                     ///< 0..1: how much of it the outside shows
    float variation = 0;  ///< 0..0.9: by so much a body is paler or darker than others of its kind, at most
    float coat = 0;       ///< m, >= 0: so deep goes the outside's colour, as glaze does

    float refraction_index = 1;       ///< 1: opaque; up to 2.5: transparent
    float absorption[3] = {0, 0, 0};  ///< 1/m, >= 0: of light in a transparent body
    float frost = 0.1f;  ///< 0..1: share of the light that a transparent body's broken faces scatter

    bool operator==(const SurfaceLook&) const = default;
    bool isTransparent() const { return refraction_index > 1; }
};

}  // namespace demolish::engine
