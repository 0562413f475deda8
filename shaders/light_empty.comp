// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The lit picture where only floor and sky are seen; lists the other tiles for light_found.comp, which needs many registers.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/visible.glsl"
#define EMPTY
#include "common/lit_pixel.glsl"
#include "common/light_tiles.glsl"
shared uint drawn_here;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool in_picture = all(lessThan(pixel, imageSize(result)));
    if (gl_LocalInvocationIndex == 0u) drawn_here = 0u;
    barrier();
    bool drawn = false;
    for (int i = 0; i < SAMPLES && in_picture; ++i) drawn = drawn || depthOfSample(sampleIndex(pixel, SAMPLES, i)) != 0u;
    if (drawn) drawn_here = 1u;
    barrier();
    if (drawn_here != 0u) {
        if (gl_LocalInvocationIndex == 0u) tiles[atomicAdd(tile_count, 1u)] = gl_WorkGroupID.x | gl_WorkGroupID.y << 16;
        return;
    }
    if (in_picture) imageStore(result, pixel, pixelColour(pixel));
}
