// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Adds up how far the sun's light goes inside a transparent body, and what its faces take from it, and keeps the ends of its
// way: no order is needed.
#include "common/frame.glsl"
#include "common/glass_face_loss.glsl"
#include "common/glass_ends.glsl"
layout(location = 0) uniform float scattered;  // by a broken face, -log of what is left
in vec3 normal;
in vec3 position;  // m
layout(location = 0) out vec2 sums;
layout(location = 1) out vec2 ends;

void main() {
    sums = faceLoss(normalize(normal), position, scattered);
    ends = endsAt(position);
}
