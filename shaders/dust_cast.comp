// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Adds up what dust lies on the sun's way, and where: puffs as the near region of the sun's map has them, a group for each.
// One whose middle lies outside is left out. Sums are whole steps, so that they do not hang on the order.
layout(local_size_x = 32) in;
#include "common/frame.glsl"
#include "common/puff.glsl"
#include "common/dust_cast.glsl"
#include "common/effect_commands.glsl"

const float kLeastRadius = 1.0;  // texels: a smaller puff is spread over so many, or it would lie between their middles

void addPuff(Puff puff) {
    vec3 at = (frame.light_matrix[0] * vec4(puff.position_radius.xyz, 1.0)).xyz;
    if (puff.position_radius.w <= 0.0 || any(greaterThan(abs(at.xy - 0.5), vec2(0.5)))) return;
    float radius = puff.position_radius.w / frame.shadow[0].z * float(kTexels), spread = max(radius, kLeastRadius);
    float steps = kSteps * puff.depth * (radius * radius) / (spread * spread);
    vec2 middle = at.xy * float(kTexels);
    ivec2 low = max(ivec2(floor(middle - spread)), 0), high = min(ivec2(middle + spread), kTexels - 1), box = high - low + 1;
    for (int i = int(gl_LocalInvocationIndex); i < box.x * box.y; i += int(gl_WorkGroupSize.x)) {
        ivec2 texel = low + ivec2(i % box.x, i / box.x);
        vec2 from_middle = (vec2(texel) + 0.5 - middle) / spread;
        float inside = max(1.0 - dot(from_middle, from_middle), 0.0), depth = steps * inside * sqrt(inside);
        if (depth < 0.5) continue;
        imageAtomicAdd(sums, depthAt(texel), uint(depth + 0.5));
        imageAtomicAdd(sums, placeAt(texel), uint(depth * clamp(at.z, 0.0, 1.0) + 0.5));
    }
}

void main() {
    for (uint i = gl_WorkGroupID.x; i < puffCount(); i += gl_NumWorkGroups.x) addPuff(puffs[i]);
}
