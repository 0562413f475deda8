// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sums of the sun's light as later passes read them (common/glass_tint.glsl); leaves them empty for the next frame.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/glass_sums.glsl"
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    uint place = uint(at.y * kSumTexels + at.x);
    imageStore(result, at, vec4(vec2(sums[place]) / vec2(kStepsOfRadius / frame.scene.w, kStepsOfLost), 0.0, 0.0));
    sums[place] = ivec2(0);
}
