// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A grain as twelve faces.
#include "common/frame.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
centroid out vec3 world_position;
flat out vec3 world_normal;
flat out int number;
flat out int face;

void main() {
    Grain g = grains[gl_InstanceID];
    float grow = grainGrowth(g);
    face = gl_VertexID / 3;
    number = gl_InstanceID;
    GrainFace f = grainFace(g, face);
    world_position = g.position_size.xyz + grow * g.position_size.w * f.corner[gl_VertexID % 3];
    world_normal = f.normal;
    gl_Position = frame.view_projection * vec4(world_position, 1.0);
    if (grow == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
}
