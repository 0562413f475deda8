// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Where each fragment was between two frames: a screw motion from one place to the other (dual quaternions,
// Kavan et al. 2007).
layout(local_size_x = 64) in;
struct Motion {
    vec4 rotation;          // unit quaternion x y z w
    uvec4 translation_age;  // xyz: m, as bits
};
layout(std430, binding = 0) readonly buffer FragmentBefore {
    uint fragment_before[];
};
layout(std430, binding = 1) readonly buffer Before {
    Motion before[];
};
layout(std430, binding = 2) readonly buffer After {
    Motion after[];
};
layout(std430, binding = 3) writeonly buffer Between {
    Motion between[];
};
layout(location = 0) uniform float share;  // 0 before .. 1 after
layout(location = 1) uniform uint count;

vec4 product(vec4 a, vec4 b) {
    return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
}
vec4 conjugate(vec4 q) {
    return vec4(-q.xyz, q.w);
}
vec4 dualPart(Motion m) {
    return 0.5 * product(vec4(uintBitsToFloat(m.translation_age.xyz), 0.0), m.rotation);
}

void main() {
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= count) return;
    // A slot is a particle's number: what broke off since was part of that particle's fragment before.
    Motion from = before[min(fragment_before[slot], count - 1u)], to = after[slot];
    float side = dot(from.rotation, to.rotation) < 0.0 ? -1.0 : 1.0;
    vec4 real = mix(from.rotation, side * to.rotation, share);
    vec4 dual = mix(dualPart(from), side * dualPart(to), share);
    float size = length(real);
    real /= size;
    dual /= size;
    vec3 translation = 2.0 * product(dual, conjugate(real)).xyz;
    between[slot] = Motion(real, uvec4(floatBitsToUint(translation), to.translation_age.w));
}
