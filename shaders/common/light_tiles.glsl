// SPDX-License-Identifier: Apache-2.0
// Tiles of 8 x 8 px that show more than floor and sky: x in the low half, y in the high half.
// The list takes the place of the one that common/raster.glsl has there.
layout(std430, binding = 8) buffer LightTiles { uint found_count, large_count, task_count, tile_count, tiles[]; };
layout(PICTURE_FORMAT, binding = 0) writeonly uniform image2D result;
