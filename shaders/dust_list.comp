// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The puffs that reach a square of the sums, in their order: what is born together may lie far apart.
layout(local_size_x = 256) in;
#include "common/seen_puff.glsl"
#define PUFFS_ACCESS readonly
#define LISTS_ACCESS writeonly
#include "common/puff_boxes.glsl"
shared uint found[8];

void main() {
    uint lane = gl_LocalInvocationIndex, square = gl_WorkGroupID.x, at = listAt(square) + 1u, listed = 0u;
    uvec2 first = uint(squares.z) * uvec2(square % uint(squares.w), square / uint(squares.w));
    for (uint base = 0u; base < puffCount(); base += gl_WorkGroupSize.x) {
        if (lane < 8u) found[lane] = 0u;
        barrier();
        uint i = base + lane;
        bool own = i < puffCount() && reaches(puff_boxes[i], first, uint(squares.z));
        if (own) atomicOr(found[lane >> 5], 1u << (lane & 31u));
        barrier();
        uint before = listed;
        for (uint word = 0u; word < 8u; ++word) {
            if (word < lane >> 5) before += uint(bitCount(found[word]));
            listed += uint(bitCount(found[word]));
        }
        if (own) puff_lists[at + before + uint(bitCount(found[lane >> 5] & ((1u << (lane & 31u)) - 1u)))] = i;
        barrier();
    }
    if (lane == 0u) puff_lists[at - 1u] = listed;
}
