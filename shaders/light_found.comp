// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The lit picture in the pixels that show something (light_empty.comp). Leaves what it has read empty for the next frame.
layout(local_size_x = 64) in;
#define COMPUTED
#include "common/lit_pixel.glsl"
#include "common/light_pixels.glsl"

void forget(ivec2 pixel) {
    for (int i = 0; i < SAMPLES; ++i) {
        visible[nameWord(sampleIndex(pixel, SAMPLES, i))] = 0u;
        visible[depthWord(sampleIndex(pixel, SAMPLES, i))] = 0u;
        visible[crackWord(pixel, SAMPLES, i)] = 0u;
    }
}

void main() {
    uint lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint k = gl_GlobalInvocationID.x; k < pixel_count; k += lanes) {
        if (pixels_found[k] == kNoPixel) continue;
        ivec2 pixel = ivec2(pixels_found[k] & 0xffffu, pixels_found[k] >> 16);
        imageStore(result, pixel, pixelColour(pixel));
        forget(pixel);
    }
}
