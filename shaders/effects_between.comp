// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Where each grain or puff was between two frames. What was born or replaced since stays where it is, but for
// sparks, which are seen by their way: they come from where they were struck.
layout(local_size_x = 64) in;
struct Flying {
    vec4 position_size;
    uvec4 rest;  // z: seed; of grains x, y: a spark's velocity and age, w: its heat, 0 of grit
};
layout(std430, binding = 0) readonly buffer Before {
    Flying before[];
};
layout(std430, binding = 1) readonly buffer After {
    Flying after[];
};
layout(std430, binding = 2) writeonly buffer Between {
    Flying between[];
};
layout(location = 0) uniform float share;  // 0 before .. 1 after
layout(location = 1) uniform uint count;
layout(location = 2) uniform float frame_s;  // from before to after, of grains; of puffs 0

// Its velocity is that of the way that it is moved along, so that its streaks join.
void moveSpark(inout Flying spark, Flying from, bool same) {
    vec2 rest = unpackHalf2x16(spark.rest.y);
    vec3 velocity = vec3(unpackHalf2x16(spark.rest.x), rest.x);
    float back = (1.0 - share) * frame_s;
    if (same) velocity = (spark.position_size.xyz - from.position_size.xyz) / frame_s;
    spark.position_size.xyz -= back * velocity;
    spark.rest.x = packHalf2x16(velocity.xy);
    spark.rest.y = packHalf2x16(vec2(velocity.z, rest.y - back));
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= count) return;
    Flying from = before[slot], to = after[slot];
    bool same = from.rest.z == to.rest.z && from.position_size.w > 0.0 && to.position_size.w > 0.0;
    bool glows = frame_s > 0.0 && to.position_size.w > 0.0 && uintBitsToFloat(to.rest.w) > 0.0;
    if (glows)
        moveSpark(to, from, same);
    else if (same)
        to.position_size = mix(from.position_size, to.position_size, share);
    between[slot] = to;
}
