// SPDX-License-Identifier: Apache-2.0
#version 450 core
// What the outside sends out of itself, where it is what a sample shows.
#include "common/model_looks.glsl"
#include "common/drawn_look.glsl"
in vec3 world_position;
layout(location = 0) out vec4 glow;

void main() {
    Laid laid = drawnLaid(world_position);
    glow = glowOf(drawnLook(), laid);
}
