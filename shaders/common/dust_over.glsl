// SPDX-License-Identifier: Apache-2.0
// Dust before what a pixel shows.
layout(binding = 12) uniform sampler2D dust_sums;  // of dust.frag, smaller than the picture
#ifdef SHADOW_DRAFT
const float kDustPixels = 4.0;  // of the picture, along one of the sums; as engine/passes/dust_pass.cpp
#else
const float kDustPixels = 2.0;
#endif

bool dustIsSeen() { return frame.floor_bounce.w > 0.0; }

// From its sums: premultiplied light of the dust, and how much it hides.
vec4 dustOf(vec4 sum) {
    float hidden = 1.0 - exp(-sum.a);
    return vec4(sum.rgb / max(sum.a, 1e-4) * hidden, hidden);
}

// Before a pixel, whatever lies there.
vec4 dustBefore(ivec2 pixel) {
    vec4 dust = vec4(0.0);
    // A loop in place of a branch, as in lit_pixel.glsl.
    for (bool any = dustIsSeen(); any; any = false)
        dust = dustOf(textureLod(dust_sums, (vec2(pixel) + 0.5) / (kDustPixels * vec2(textureSize(dust_sums, 0))), 0.0));
    return dust;
}
