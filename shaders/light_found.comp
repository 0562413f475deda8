// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The lit picture in the tiles that show something (light_empty.comp). Leaves what it has read empty for the next frame.
layout(local_size_x = 8, local_size_y = 8) in;
#define COMPUTED
#include "common/lit_pixel.glsl"
#include "common/light_tiles.glsl"

void forget(ivec2 pixel) {
    for (int i = 0; i < SAMPLES; ++i) {
        visible[nameWord(sampleIndex(pixel, SAMPLES, i))] = 0u;
        visible[depthWord(sampleIndex(pixel, SAMPLES, i))] = 0u;
        visible[crackWord(pixel, SAMPLES, i)] = 0u;
    }
}

void main() {
    for (uint k = gl_WorkGroupID.x; k < tile_count; k += gl_NumWorkGroups.x) {
        ivec2 pixel = 8 * ivec2(tiles[k] & 0xffffu, tiles[k] >> 16) + ivec2(gl_LocalInvocationID.xy);
        if (any(greaterThanEqual(pixel, imageSize(result)))) continue;
        imageStore(result, pixel, pixelColour(pixel));
        forget(pixel);
    }
}
