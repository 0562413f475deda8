// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body into a region of the sun's depth map.
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
layout(location = 0) in vec3 rest_position;
layout(location = 2) in uint cell;
layout(location = 0) uniform int region;

void main() {
    FragmentTransform t = transforms[particle_fragment[cell]];
    vec3 p = (frame.light_matrix[region] * vec4(moved(t, rest_position), 1.0)).xyz;
    gl_Position = unlessHidden(vec4(p.xy * 2.0 - 1.0, p.z, 1.0), cell);
}
