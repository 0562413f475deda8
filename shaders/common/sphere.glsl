// SPDX-License-Identifier: Apache-2.0
// One sphere of the particle view or a projectile (32 bytes).
struct Sphere {
    vec4 position_radius;  // m
    float value;           // colour channel, 0..1
    uint fragment_slot;
    uint reserved_0, reserved_1;
};
layout(std430, binding = 2) readonly buffer Spheres { Sphere spheres[]; };
