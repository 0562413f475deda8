// SPDX-License-Identifier: Apache-2.0
// Where a cell's vertices are now: cell -> fragment slot -> the slot's rigid motion.
#include "common/rotate.glsl"
struct FragmentTransform {
    vec4 rotation;         // unit quaternion x y z w
    vec3 translation;      // m
    uint age_shrink;       // frames; in the highest 8 bits steps by which it is drawn smaller
};
layout(std430, binding = 0) readonly buffer ParticleFragment { uint particle_fragment[]; };
layout(std430, binding = 1) readonly buffer Transforms { FragmentTransform transforms[]; };

const float kShrinkStep = 1.0 / 256.0;

vec3 moved(FragmentTransform t, vec3 p) {
    float scale = 1.0 - kShrinkStep * float(t.age_shrink >> 24);
    return rotate(t.rotation, scale * p) + t.translation;
}
