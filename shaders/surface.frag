// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body surface; INTERIOR: the broken material (common/body_material.glsl).
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/rotate.glsl"
#define BODY_MATERIAL 0
#include "common/body_material.glsl"
in vec3 world_position;
in vec3 world_normal;
in vec3 rest;
flat in vec4 rotation;
#ifdef INTERIOR
in vec2 relief;  // x: 0 at the outside .. 1 deep; y: -1 pit .. 1 ridge
#endif
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;

void main() {
    Surface s;
    s.position = world_position;
    s.geometric_normal = normalize(world_normal);
    s.normal = s.geometric_normal;
    s.metalness = 0.0;
#ifdef INTERIOR
    vec2 deeper = vec2(dFdx(relief.x), dFdy(relief.x));
    insideMaterial(s, rest, rotation, relief, coatAt(relief.x, dFdx(rest), dFdy(rest), deeper));
#else
    outsideMaterial(s, rest);
#endif
    turnToEye(s);
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
