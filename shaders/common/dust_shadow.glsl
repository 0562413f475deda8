// SPDX-License-Identifier: Apache-2.0
// What dust leaves of the sun, from its sums in the near region of the sun's map.
layout(binding = 11) uniform sampler2D dust_shadow;  // optical depth along the sun's rays; times depth in the region
const float kDustSpread = 0.015;  // of the region's depth: so far dust reaches before and behind its mean

// `p`: u, v, depth in the near region.
float throughDust(vec3 p) {
    vec2 sums = textureLod(dust_shadow, p.xy, 0.0).rg;
    float behind = smoothstep(-kDustSpread, kDustSpread, p.z - sums.g / max(sums.r, 1e-5));
    return exp(-sums.r * behind);
}
