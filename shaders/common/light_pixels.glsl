// SPDX-License-Identifier: Apache-2.0
// Pixels that show more than floor and sky: x in the low half, y in the high half.
// The list takes the place of the one that common/raster.glsl has there.
layout(std430, binding = 8) buffer LightPixels { uint found_count, large_count, task_count, pixel_count, pixels_found[]; };
layout(PICTURE_FORMAT, binding = 0) writeonly uniform image2D result;
