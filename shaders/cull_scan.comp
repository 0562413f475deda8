#version 450 core
// One work group a view: counts of the blocks become the places where their triangles go, and their sum a command.
layout(local_size_x = 1024) in;
#include "common/cull.glsl"
layout(std430, binding = 4) buffer BlockCounts { uint block_counts[]; };
layout(std430, binding = 6) readonly buffer Commands { DrawCommand commands[]; };
layout(std430, binding = 7) writeonly buffer CulledCommands { DrawCommand culled[]; };

shared uint sums[gl_WorkGroupSize.x];

void main() {
    uint thread = gl_LocalInvocationIndex, threads = gl_WorkGroupSize.x, view = gl_WorkGroupID.x;
    uint triangles = commands[source_command].count / 3u;
    uint blocks = (triangles + kTrianglesPerBlock - 1u) / kTrianglesPerBlock, run = (blocks + threads - 1u) / threads;
    uint first = view * block_room + min(thread * run, blocks);
    uint last = view * block_room + min((thread + 1u) * run, blocks);
    uint own = 0u;
    for (uint b = first; b < last; ++b) own += block_counts[b];
    sums[thread] = own;
    barrier();
    for (uint step = 1u; step < threads; step *= 2u) {
        uint before = thread >= step ? sums[thread - step] : 0u;
        barrier();
        sums[thread] += before;
        barrier();
    }
    uint place = sums[thread] - own;
    for (uint b = first; b < last; ++b) {
        uint count = block_counts[b];
        block_counts[b] = place;
        place += count;
    }
    uint first_index = 3u * kTrianglesPerBlock * block_room * view;
    if (thread == threads - 1u) culled[view] = DrawCommand(3u * place, 1u, first_index, 0u, 0u);
}
