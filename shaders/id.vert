// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body vertices carrying their fragment's slot.
#include "common/frame.glsl"
#include "common/body.glsl"
layout(location = 0) in vec3 rest_position;
layout(location = 2) in uint cell;
flat out uint fragment_slot;

void main() {
    fragment_slot = particle_fragment[cell];
    gl_Position = frame.view_projection * vec4(moved(transforms[fragment_slot], rest_position), 1.0);
}
