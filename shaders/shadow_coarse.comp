// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Least depth of each square of 64 x 64 texels of the shadow map: one work group a square.
layout(local_size_x = 256) in;
layout(binding = 1) uniform sampler2D shadow_depth;
layout(r32f, binding = 0) uniform writeonly image2D coarse;
const int kCoarseTexels = 64;
shared float nearest[gl_WorkGroupSize.x];

void main() {
    int lane = int(gl_LocalInvocationIndex), lanes = int(gl_WorkGroupSize.x);
    ivec2 corner = kCoarseTexels * ivec2(gl_WorkGroupID.xy);
    float least = 1.0;
    for (int k = lane; k < kCoarseTexels * kCoarseTexels; k += lanes) {
        least = min(least, texelFetch(shadow_depth, corner + ivec2(k % kCoarseTexels, k / kCoarseTexels), 0).r);
    }
    nearest[lane] = least;
    barrier();
    for (int half_of = lanes / 2; half_of > 0; half_of /= 2) {
        if (lane < half_of) nearest[lane] = min(nearest[lane], nearest[lane + half_of]);
        barrier();
    }
    if (lane == 0) imageStore(coarse, ivec2(gl_WorkGroupID.xy), vec4(nearest[0]));
}
