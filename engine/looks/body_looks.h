// SPDX-License-Identifier: Apache-2.0
// What the models of a scene look like on their outside: plain values, as FractureMesh takes them.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace demolish::engine {

inline constexpr uint32_t kNoPicture = 0xffffffffu;

/// RGBA of 8 bits a texel, upper row first.
struct LookPicture {
    uint32_t width = 0, height = 0;  ///< px, > 0
    std::span<const uint8_t> texels;
};

enum class PictureWrap : uint8_t { kRepeat, kClamp, kMirror };

/// A picture laid over the body by UVs, v upwards.
struct PictureUse {
    uint32_t picture = kNoPicture;
    uint8_t channel = 0;  ///< 0 to 3, where a single number is wanted
    PictureWrap wrap_u = PictureWrap::kRepeat, wrap_v = PictureWrap::kRepeat;
    uint8_t uv_set = 0;  ///< 0: LookTriangle::uv, 1: second_uv
};

/// Numbers times pictures. Colours are linear, pictures of colours sRGB.
struct LookMaterial {
    float base_colour[4] = {1, 1, 1, 1};
    float emission[3] = {0, 0, 0};
    float metallic = 0, roughness = 1, normal_scale = 1, occlusion_strength = 1;
    float alpha_cutoff = 0;  ///< what is less opaque is not there; 0: all is; < 0: as much as is opaque
    bool is_double_sided = false;
    PictureUse base, normal, roughness_map, metallic_map, occlusion, emission_map;
};

inline constexpr uint32_t kNoLook = 0xffffffffu;

/// A triangle of the uncut mesh, by whose numbers exterior vertices go (their `place`).
struct LookTriangle {
    float corner[3][3];  ///< m, at rest
    float uv[3][2], second_uv[3][2];
    uint32_t colour[3];  ///< RGBA, red lowest, sRGB
    uint32_t material;   ///< kNoLook: as SurfaceLook has the outside
};

struct BodyLooks {
    std::vector<LookMaterial> materials;
    std::vector<LookPicture> pictures;
    std::vector<LookTriangle> triangles;
};

}  // namespace demolish::engine
