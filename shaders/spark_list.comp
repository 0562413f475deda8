// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Which grains glow, in their order: few do, and four vertices for each that does not would take longer than all else.
layout(local_size_x = 256) in;
#include "common/frame.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
#include "common/effect_commands.glsl"
layout(std430, binding = 8) writeonly buffer SparkIds { uint spark_ids[]; };              // from the group's first place on
layout(std430, binding = 9) writeonly buffer SparkCommands { uvec4 spark_commands[]; };   // of a group, as glDrawArraysIndirect
const uint kGroup = 2048u, kRounds = kGroup / gl_WorkGroupSize.x;  // as engine/passes/spark_pass.cpp
shared uint glowing[kGroup / 32u];

uint glowingBefore(uint place) {
    uint sum = 0u;
    for (uint word = 0u; word < place >> 5; ++word) sum += uint(bitCount(glowing[word]));
    uint rest = place & 31u;
    return rest == 0u ? sum : sum + uint(bitCount(glowing[place >> 5] & ((1u << rest) - 1u)));
}

void main() {
    uint lane = gl_LocalInvocationIndex, first = kGroup * gl_WorkGroupID.x, count = grainCount();
    if (lane < kGroup / 32u) glowing[lane] = 0u;
    barrier();
    for (uint round = 0u; round < kRounds; ++round) {
        uint place = round * gl_WorkGroupSize.x + lane;
        if (first + place >= count) continue;
        if (grains[first + place].position_size.w > 0.0 && grains[first + place].heat > 0.0)
            atomicOr(glowing[place >> 5], 1u << (place & 31u));
    }
    barrier();
    for (uint round = 0u; round < kRounds; ++round) {
        uint place = round * gl_WorkGroupSize.x + lane;
        if ((glowing[place >> 5] >> (place & 31u) & 1u) != 0u) spark_ids[first + glowingBefore(place)] = first + place;
    }
    if (lane == 0u) spark_commands[gl_WorkGroupID.x] = uvec4(4u, glowingBefore(kGroup - 1u) + (glowing[kGroup / 32u - 1u] >> 31), 0u, first);
}
