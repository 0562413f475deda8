// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Spheres by their fragment's slot.
#include "common/frame.glsl"
#include "common/sphere_hit.glsl"
layout(depth_less) out float gl_FragDepth;
layout(location = 0) out uint id;

void main() {
    vec3 ray = normalize(on_square - frame.eye.xyz);
    float inside = sphereDepth(ray);
    if (inside < 0.0) discard;
    gl_FragDepth = clipDepth(sphereHit(ray, inside));
    id = fragment_slot;
}
