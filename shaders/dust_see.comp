// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Puffs as their sums will see them, with the boxes that they take there.
layout(local_size_x = 64) in;
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/see_puff.glsl"
#define PUFFS_ACCESS writeonly
#define LISTS_ACCESS readonly
#include "common/puff_boxes.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= puffCount()) return;
    SeenPuff puff = seenPuff(puffs[i]);
    seen_puffs[i] = puff;
    puff_boxes[i] = uvec2(kNoBox, 0u);
    vec2 most = vec2(squares.xy) - 1.0;
    float reach = puff.place.w / max(puff.place.z, 1e-9);
    vec2 low = puff.place.xy - reach, high = puff.place.xy + reach;
    if (puff.position_radius.w <= 0.0 || any(lessThan(high, vec2(0.0))) || any(greaterThan(low, most + 1.0))) return;
    uvec2 first = uvec2(clamp(low, vec2(0.0), most)), last = uvec2(clamp(high, vec2(0.0), most));
    puff_boxes[i] = uvec2(first.x | first.y << 16, last.x | last.y << 16);
}
