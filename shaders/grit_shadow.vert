// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Grains into a region of the sun's depth map; those much smaller than a texel cast no shadow there.
#include "common/frame.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
layout(location = 0) uniform int region;
const float kLeastTexels = 0.7;

void main() {
    Grain g = grains[gl_InstanceID];
    int face = gl_VertexID / 3;
    GrainFace f = grainFace(g, face);
    vec3 world = g.position_size.xyz + g.position_size.w * f.corner[gl_VertexID % 3];
    vec3 p = (frame.light_matrix[region] * vec4(world, 1.0)).xyz;
    gl_Position = vec4(p.xy * 2.0 - 1.0, p.z, 1.0);
    if (g.heat > 0.0 || g.position_size.w < kLeastTexels * frame.shadow[region].x) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
