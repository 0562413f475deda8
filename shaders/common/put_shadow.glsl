// SPDX-License-Identifier: Apache-2.0
// The shadow map of passes that compute: depths as bits, two regions side by side, the least one wins.
layout(binding = 0, r32ui) uniform coherent uimage2D shadow_map;
layout(location = 7) uniform int shadow_texels;  // along a region; 0: the map is not drawn

void putShadow(ivec2 pixel, int region, float depth) {
    ivec2 at = pixel + ivec2(region * shadow_texels, 0);
    uint bits = depth > 0.0 ? floatBitsToUint(min(depth, 1.0)) : 0u;
    if (bits < imageLoad(shadow_map, at).r) imageAtomicMin(shadow_map, at, bits);
}
