// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A face of a grain.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/rotate.glsl"
#define BODY_MATERIAL 0
#include "common/body_material.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
centroid in vec3 world_position;
flat in vec3 world_normal;
flat in int number;
flat in int face;
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;

void main() {
    Surface s;
    s.position = world_position;
    s.geometric_normal = world_normal;
    s.normal = world_normal;
    s.metalness = 0.0;
    grainMaterial(s, grains[number], face);
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
