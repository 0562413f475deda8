// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sums of dust.frag, computed: each tile adds up the puffs of its square that reach it, in their order. A GPU has many
// times more units that compute than units that draw, and its sums are not rounded after each puff.
layout(local_size_x = 8, local_size_y = 8, local_size_z = 4) in;  // lanes of a pixel share its puffs
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/sky.glsl"
#include "common/solid.glsl"
#include "common/puff_light.glsl"
#define PUFFS_ACCESS readonly
#define LISTS_ACCESS readonly
#include "common/puff_boxes.glsl"
layout(rgba16f, binding = 0) writeonly uniform image2D sums;
const uint kAtOnce = 256u, kShares = 4u;
shared uint found[kAtOnce / 32u], numbers[kAtOnce];
shared vec4 shares[kShares][64];

// Of a square's puffs those whose turn it is in this share of each kAtOnce.
vec4 shareOf(uint first, uint count, vec2 place, vec3 ray, float solid) {
    uint lane = gl_LocalInvocationIndex, own = gl_LocalInvocationID.z * kAtOnce / kShares;
    vec4 sum = vec4(0.0);
    for (uint base = 0u; base < count; base += kAtOnce) {
        barrier();
        if (lane < kAtOnce / 32u) found[lane] = 0u;
        barrier();
        if (base + lane < count) {
            numbers[lane] = puff_lists[first + base + lane];
            if (reaches(puff_boxes[numbers[lane]], 8u * gl_WorkGroupID.xy, 8u)) atomicOr(found[lane >> 5], 1u << (lane & 31u));
        }
        barrier();
        for (uint part = own; part < own + kAtOnce / kShares; part += 32u) {
            for (uint left = found[part >> 5]; left != 0u; left &= left - 1u) {
                SeenPuff puff = seen_puffs[numbers[part + uint(findLSB(left))]];
                sum += puffAlong(puff, puff.place.z * (place - puff.place.xy), ray, solid);
            }
        }
    }
    return sum;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    vec2 place = vec2(pixel) + 0.5, at = min(place * pixels, frame.viewport.xy - 1.0);
    vec3 ray = rayThrough(place * pixels);
    uvec2 square = 8u * gl_WorkGroupID.xy / uint(squares.z);
    uint first = listAt(square.y * uint(squares.w) + square.x), own = gl_LocalInvocationIndex % 64u;
    shares[gl_LocalInvocationID.z][own] = shareOf(first + 1u, puff_lists[first], place, ray, solidAlong(at, ray));
    barrier();
    if (gl_LocalInvocationID.z != 0u || any(greaterThanEqual(pixel, squares.xy))) return;
    imageStore(sums, pixel, (shares[0][own] + shares[1][own]) + (shares[2][own] + shares[3][own]));
}
