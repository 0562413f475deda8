// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Empties what the raster passes write.
layout(local_size_x = 256) in;
layout(std430, binding = 7) writeonly buffer Visible { uvec4 visible[]; };
layout(std430, binding = 8) writeonly buffer Found { uint found_count, large_count, task_count, pixel_count; };
layout(binding = 0, r32ui) uniform writeonly uimage2D shadow_map;
layout(location = 0) uniform uint fours;         // of words in `visible`
layout(location = 7) uniform int shadow_texels;  // along a region; 0: the map stays

void main() {
    uint lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x, lane = gl_GlobalInvocationID.x;
    if (lane == 0u) {
        found_count = 0u;
        large_count = 0u;
        task_count = 0u;
        pixel_count = 0u;
    }
    for (uint k = lane; k < fours; k += lanes) visible[k] = uvec4(0u);
    int width = 2 * shadow_texels;
    for (int k = int(lane); k < width * shadow_texels; k += int(lanes))
        imageStore(shadow_map, ivec2(k % width, k / width), uvec4(floatBitsToUint(1.0)));
}
