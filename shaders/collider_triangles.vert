// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A collider of triangles as the camera sees it, or, with SHADOW, as the sun does.
#include "common/frame.glsl"
#include "common/rotate.glsl"
layout(location = 0) in vec3 own_position;
layout(location = 1) in vec3 own_normal;
layout(location = 1) uniform vec4 place;    // xyz: m; w: 1 of steel
layout(location = 2) uniform vec4 turn;     // quaternion
layout(location = 3) uniform vec4 stretch;  // xyz: how much larger along each axis
#ifdef SHADOW
layout(location = 0) uniform int region;
#endif
out vec3 world_position;
out vec3 world_normal;

void main() {
    world_position = place.xyz + rotate(turn, stretch.xyz * own_position);
    world_normal = rotate(turn, own_normal / stretch.xyz);
#ifdef SHADOW
    vec3 p = (frame.light_matrix[region] * vec4(world_position, 1.0)).xyz;
    gl_Position = vec4(p.xy * 2.0 - 1.0, p.z, 1.0);
#else
    gl_Position = frame.view_projection * vec4(world_position, 1.0);
#endif
}
