// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The lit picture in pixels where only floor and sky are seen; lists the others for light_found.comp, which needs many registers.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/visible.glsl"
#define EMPTY
#include "common/lit_pixel.glsl"
#include "common/light_pixels.glsl"
shared uint found_here, first_place;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool in_picture = all(lessThan(pixel, imageSize(result))), drawn = false;
    if (gl_LocalInvocationIndex == 0u) found_here = 0u;
    barrier();
    for (int i = 0; i < SAMPLES && in_picture; ++i) drawn = drawn || depthOfSample(sampleIndex(pixel, SAMPLES, i)) != 0u;
    uint place = drawn ? atomicAdd(found_here, 1u) : 0u;
    barrier();
    uint room = (found_here + kTogether - 1u) / kTogether * kTogether, lane = gl_LocalInvocationIndex;
    if (lane == 0u && room != 0u) first_place = atomicAdd(pixel_count, room);
    barrier();
    if (lane < room - found_here) pixels_found[first_place + found_here + lane] = kNoPixel;
    if (drawn) pixels_found[first_place + place] = uint(pixel.x) | uint(pixel.y) << 16;
    else if (in_picture) imageStore(result, pixel, pixelColour(pixel));
}
