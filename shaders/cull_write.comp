#version 450 core
// The triangles that may be seen, in their own order, for each view.
layout(local_size_x = 256) in;
#include "common/cull.glsl"
layout(std430, binding = 2) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 3) readonly buffer SeenBits { uint seen_bits[]; };
layout(std430, binding = 4) readonly buffer BlockPlaces { uint block_places[]; };
layout(std430, binding = 6) readonly buffer Commands { DrawCommand commands[]; };
layout(std430, binding = 7) writeonly buffer CulledIndices { uint culled_indices[]; };

void main() {
    uint thread = gl_LocalInvocationIndex, triangles = commands[source_command].count / 3u;
    uint blocks = (triangles + kTrianglesPerBlock - 1u) / kTrianglesPerBlock;
    for (uint block = gl_WorkGroupID.x; block < blocks; block += gl_NumWorkGroups.x) {
        uint from = 3u * (block * kTrianglesPerBlock + thread);
        for (uint view = 0u; view < kViews; ++view) {
            uint first_word = (view * block_room + block) * kWordsPerBlock;
            uint own = seen_bits[first_word + thread / 32u], bit = 1u << (thread & 31u);
            if ((own & bit) == 0u) continue;
            uint place = block_places[view * block_room + block] + uint(bitCount(own & (bit - 1u)));
            for (uint k = 0u; k < thread / 32u; ++k) place += uint(bitCount(seen_bits[first_word + k]));
            uint to = 3u * (kTrianglesPerBlock * block_room * view + place);
            for (uint k = 0u; k < 3u; ++k) culled_indices[to + k] = indices[from + k];
        }
    }
}
