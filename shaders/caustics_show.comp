// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The light on the floor as later passes read it (common/glass_tint.glsl): times what is there without transparent bodies.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/caustics.glsl"
#include "common/tile_levels.glsl"
layout(rgba16f, binding = 0) writeonly uniform image2D result;
layout(rgba16f, binding = 1) writeonly uniform image2D coarser;  // its next level

vec3 coarseLight(ivec2 at) {
    return vec3(caustics[kCoarse + at.y * kCoarseTexels + at.x].rgb) / kStepsOfLight;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec4 sum = caustics[at.y * kCausticTexels + at.x];
    vec3 light = 1.0 - 0.25 * float(sum.w) + vec3(sum.rgb) / kStepsOfLight;
    float finer = float(kCausticTexels / kCoarseTexels);
    vec2 coarse = (vec2(at) + 0.5) / finer - 0.5, low = floor(coarse), f = coarse - low;
    for (int k = 0; k < 4; ++k) {
        vec2 corner = vec2(k & 1, k >> 1), w = mix(1.0 - f, f, corner);
        light += w.x * w.y * coarseLight(clamp(ivec2(low + corner), 0, kCoarseTexels - 1)) / (finer * finer);
    }
    imageStore(result, at, vec4(light, 1.0));
    vec4 mean = halved(vec4(light, 1.0), 4u);
    if (isInLevel(4u)) imageStore(coarser, placeInLevel(4u), mean);
}
