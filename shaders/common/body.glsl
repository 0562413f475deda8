// SPDX-License-Identifier: Apache-2.0
// Where a cell's vertices are now: cell -> fragment slot -> the slot's rigid motion.
#include "common/rotate.glsl"
struct FragmentTransform {
    vec4 rotation;         // unit quaternion x y z w
    vec4 translation_age;  // xyz: m
};
layout(std430, binding = 0) readonly buffer ParticleFragment { uint particle_fragment[]; };
layout(std430, binding = 1) readonly buffer Transforms { FragmentTransform transforms[]; };

vec3 moved(FragmentTransform t, vec3 p) { return rotate(t.rotation, p) + t.translation_age.xyz; }
