// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sums of the sun's light as later passes read them (common/glass_tint.glsl); leaves them empty for the next frame.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/glass_sums.glsl"
#include "common/glass_ends.glsl"
#include "common/tile_levels.glsl"
layout(rg32f, binding = 0) writeonly uniform image2D result;
layout(rg32f, binding = 1) writeonly uniform image2D ends;
layout(rg32f, binding = 2) writeonly uniform image2D coarser[3];  // the levels after it

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    uint place = uint(at.y * kSumTexels + at.x);
    ivec4 sum = sums[place];
    vec4 inside_lost = vec4(vec2(sum.xy) / vec2(kStepsOfRadius / frame.scene.w, kStepsOfLost), 0.0, 0.0);
    imageStore(result, at, inside_lost);
    imageStore(ends, at, vec4(sum.z == 0 ? vec2(kNoEnd) : vec2(sum.zw - 1) / kStepsOfEnds, 0.0, 0.0));
    sums[place] = ivec4(0);
    for (int level = 0; level < 3; ++level) {
        uint side = 4u >> level;
        inside_lost = halved(inside_lost, side);
        if (isInLevel(side)) imageStore(coarser[level], placeInLevel(side), inside_lost);
    }
}
