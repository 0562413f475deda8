// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sums of the sun's light as later passes read them (common/glass_tint.glsl); leaves them empty for the next frame.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/glass_sums.glsl"
#include "common/glass_ends.glsl"
layout(rg32f, binding = 0) writeonly uniform image2D result;
layout(rg32f, binding = 1) writeonly uniform image2D ends;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    uint place = uint(at.y * kSumTexels + at.x);
    ivec4 sum = sums[place];
    imageStore(result, at, vec4(vec2(sum.xy) / vec2(kStepsOfRadius / frame.scene.w, kStepsOfLost), 0.0, 0.0));
    imageStore(ends, at, vec4(sum.z == 0 ? vec2(kNoEnd) : vec2(sum.zw - 1) / kStepsOfEnds, 0.0, 0.0));
    sums[place] = ivec4(0);
}
