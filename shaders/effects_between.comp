// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Where each grain or puff was between two frames. What was born or replaced since stays where it is.
layout(local_size_x = 64) in;
struct Flying {
    vec4 position_size;
    uvec4 rest;  // z: seed
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

void main() {
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= count) return;
    Flying from = before[slot], to = after[slot];
    bool same = from.rest.z == to.rest.z && from.position_size.w > 0.0 && to.position_size.w > 0.0;
    if (same) to.position_size = mix(from.position_size, to.position_size, share);
    between[slot] = to;
}
