// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sums of the dust's shadow as later passes read them (common/dust_shadow.glsl); leaves them empty for the next frame.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/dust_cast.glsl"
layout(rg16f, binding = 1) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 sum = vec2(imageLoad(sums, depthAt(texel)).r, imageLoad(sums, placeAt(texel)).r);
    imageStore(result, texel, vec4(sum / kSteps, 0.0, 0.0));
    imageStore(sums, depthAt(texel), uvec4(0u));
    imageStore(sums, placeAt(texel), uvec4(0u));
}
