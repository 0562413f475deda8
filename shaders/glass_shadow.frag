// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Adds up how far the sun's light goes inside a transparent body, and what its faces take from it: no order is needed.
#include "common/frame.glsl"
layout(location = 0) uniform float scattered;  // by a broken face, -log of what is left
in vec3 normal;
in float along;
layout(location = 0) out vec2 sums;

const float kBent = 0.9;  // what slanting faces bend out of its way

void main() {
    float facing = dot(normalize(normal), frame.to_sun.xyz), steep = clamp(abs(facing), 0.05, 1.0);
    float mirrored = 0.04 + 0.96 * pow(1.0 - steep, 5.0);
    sums = vec2(facing < 0.0 ? along : -along, kBent * pow(1.0 - steep, 1.5) - log(1.0 - min(mirrored, 0.95)) + scattered);
}
