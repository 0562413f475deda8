// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The sun sees a disc; its square in the shadow map.
#include "common/frame.glsl"
#include "common/sphere.glsl"
layout(location = 0) uniform int region;
out vec2 on_disc;
flat out float depth_radius;
flat out float centre_depth;

void main() {
    Sphere s = spheres[gl_InstanceID];
    on_disc = vec2(2 * (gl_VertexID >> 1) - 1, 1 - 2 * (gl_VertexID & 1));
    vec3 p = (frame.light_matrix[region] * vec4(s.position_radius.xyz, 1.0)).xyz;
    float r = s.position_radius.w;
    centre_depth = p.z;
    depth_radius = r / frame.shadow[region].w;
    gl_Position = vec4(2.0 * (p.xy + on_disc * r / frame.shadow[region].z) - 1.0, max(p.z - depth_radius, 0.0), 1.0);
}
