// SPDX-License-Identifier: Apache-2.0
// What a model file says of its looks: materials, and pictures decoded.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace demolish {

inline constexpr uint32_t kNoImage = 0xffffffffu;

/// RGBA of 8 bits a texel, upper row first.
struct LookImage {
    uint32_t width = 0, height = 0;  ///< px
    std::vector<uint8_t> texels;
};

enum class TextureWrap : uint8_t { kRepeat, kClamp, kMirror };

/// A picture laid over the model by its UVs.
struct ImageUse {
    uint32_t image = kNoImage;
    uint8_t channel = 0;  ///< 0 to 3: of RGBA, where a single number is wanted
    TextureWrap wrap_u = TextureWrap::kRepeat, wrap_v = TextureWrap::kRepeat;
    uint8_t uv_set = 0;  ///< 0: CornerAttributes::uv, 1: second_uv

    bool operator==(const ImageUse&) const = default;
};

inline constexpr float kBlends = -1;  ///< as an alpha_cutoff

/// As glTF has it: each picture is multiplied by its number. Colours are linear, pictures of colours sRGB.
struct LookMaterial {
    float base_colour[4] = {1, 1, 1, 1};
    float emission[3] = {0, 0, 0};
    float metallic = 0, roughness = 1;
    float normal_scale = 1;
    float occlusion_strength = 1;
    float alpha_cutoff = 0;  ///< what is less opaque is not there; 0: all is; kBlends: as much as is opaque
    uint32_t is_double_sided = 0;
    uint32_t says_nothing = 0;  ///< 1: the file names it and no more, so that the outside is the body's own
    ImageUse base_map, normal_map, metallic_map, roughness_map, occlusion_map, emission_map;

    bool operator==(const LookMaterial&) const = default;
};
static_assert(sizeof(LookMaterial) == 104, "no bytes between the members that nobody has set");

inline constexpr uint32_t kMostImageEdge = 16384;               ///< px
inline constexpr uint64_t kMostImageBytes = uint64_t{2} << 30;  ///< of all pictures of a model, decoded
inline constexpr uint32_t kMostImages = 1024, kMostMaterials = 65536;

struct ModelLooks {
    std::vector<LookMaterial> materials;
    std::vector<LookImage> images;
    bool has_colours = false;        ///< corners have colours of their own
    std::vector<std::string> notes;  ///< what could not be taken over, a sentence without full stop each
};

}  // namespace demolish
