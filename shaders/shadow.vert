// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body into a region of the sun's depth map.
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
#include "common/leave_near.glsl"
layout(location = 0) in vec3 rest_position;
layout(location = 2) in uint cell;
layout(location = 0) uniform int region;
#ifdef LOOKS
#include "common/model_looks.glsl"
layout(location = 4) in uint place;
out vec3 rest;
out vec4 look_uv;
out vec4 look_colour;
flat out uint look_material;
#endif

void main() {
    FragmentTransform t = transforms[particle_fragment[cell]];
    vec3 p = (frame.light_matrix[region] * vec4(moved(t, rest_position), 1.0)).xyz;
#ifdef LOOKS
    Looked look = lookedAt(place, rest_position);
    rest = rest_position;
    look_uv = look.uv;
    look_colour = look.colour;
    look_material = look.material;
#endif
    gl_Position = unlessReplaced(unlessHidden(vec4(p.xy * 2.0 - 1.0, p.z, 1.0), cell), cell);
}
