// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body vertex: rest position moved by its fragment; rest position goes on for the noise.
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
#include "common/gbuffer.glsl"
layout(location = 0) in vec3 rest_position;
layout(location = 1) in vec2 rest_normal;
layout(location = 2) in uint cell;
#ifdef INTERIOR
#include "common/leave_near.glsl"
layout(location = 3) in vec2 relief_in;
out vec2 relief;
#endif
#ifdef LOOKS
#include "common/model_looks.glsl"
layout(location = 4) in uint place;
out vec4 look_uv;
out vec4 look_colour;
flat out uint look_material;
#endif

out vec3 world_position;
out vec3 world_normal;
out vec3 rest;
flat out vec4 rotation;
flat out float tone;  // of the body
layout(location = 4) uniform vec4 texture_shape;  // as common/body_material.glsl has it

void main() {
    FragmentTransform t = transforms[particle_fragment[cell]];
    world_position = moved(t, rest_position);
    world_normal = rotate(t.rotation, decodeOctahedral(rest_normal));
    rest = rest_position + cutFrom(texture_shape.w, cell);
    rotation = t.rotation;
    tone = paleness(texture_shape.w, cell);
#ifdef INTERIOR
    relief = relief_in;
#endif
#ifdef LOOKS
    Looked look = lookedAt(place, rest_position);
    look_uv = look.uv;
    look_colour = look.colour;
    look_material = look.material;
#endif
    gl_Position = unlessHidden(frame.view_projection * vec4(world_position, 1.0), cell);
#ifdef INTERIOR
    gl_Position = unlessReplaced(gl_Position, cell);
#endif
}
