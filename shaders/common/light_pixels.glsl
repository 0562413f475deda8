// SPDX-License-Identifier: Apache-2.0
// Pixels that show more than floor and sky: x in the low half, y in the high half.
// Each tile's begin at a multiple of kTogether, and kNoPixel fills it up: software renderers take one mip map for so many lanes.
// The list takes the place of the one that common/raster.glsl has there.
layout(std430, binding = 8) buffer LightPixels { uint found_count, large_count, task_count, pixel_count, pixels_found[]; };
const uint kTogether = 4u, kNoPixel = 0xffffffffu;
layout(PICTURE_FORMAT, binding = 0) writeonly uniform image2D result;
