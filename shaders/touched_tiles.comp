// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Lists the tiles of a depth buffer in which something was drawn; one work group looks at one tile. The list is an
// indirect command that draws one square a tile (touched_tiles.vert).
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef MULTISAMPLE
layout(binding = 0) uniform sampler2DMS depth_buffer;
#else
layout(binding = 0) uniform sampler2D depth_buffer;
#endif
layout(std430, binding = 6) buffer TouchedTiles {
    uint vertices_per_tile, tile_count, first_vertex, first_tile;
    uint tiles[];  // x in the low half, y in the high half
};
layout(location = 0) uniform float empty_depth;
layout(location = 1) uniform int samples;
const ivec2 kPixelsPerLane = ivec2(2);  // tiles of 16 x 16 px
shared uint touched;

void main() {
    if (gl_LocalInvocationIndex == 0u) touched = 0u;
    barrier();
    ivec2 last = ivec2(textureSize(depth_buffer
#ifndef MULTISAMPLE
                                   , 0
#endif
                                   )) - 1;
    bool found = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 pixel = min(kPixelsPerLane * ivec2(gl_GlobalInvocationID.xy) + ivec2(k & 1, k >> 1), last);
        for (int i = 0; i < samples; ++i) found = found || texelFetch(depth_buffer, pixel, i).r != empty_depth;
    }
    if (found) touched = 1u;
    barrier();
    if (gl_LocalInvocationIndex == 0u && touched != 0u) {
        tiles[atomicAdd(tile_count, 1u)] = gl_WorkGroupID.x | gl_WorkGroupID.y << 16;
    }
}
