// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The picture with what is transparent, computed (common/walked_pixel.glsl).
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/walked_pixel.glsl"
layout(PICTURE_FORMAT, binding = 0) writeonly uniform image2D result;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    imageStore(result, pixel, pixelWalked(pixel));
}
