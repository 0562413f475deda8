// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Body surface; INTERIOR: the broken material (common/body_material.glsl); LOOKS: the outside as its model file says.
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
flat in float tone;
#ifdef INTERIOR
in vec2 relief;  // x: 0 at the outside .. 1 deep; y: -1 pit .. 1 ridge
#endif
#ifdef LOOKS
#include "common/model_material.glsl"
#include "common/drawn_look.glsl"
#include "common/model_holes.glsl"
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
    s.albedo *= tone;
#ifdef LOOKS
    Looked look = drawnLook();
    Laid laid = drawnLaid(world_position);
    int covered = coveredSamples(look, laid);
    if (covered == 0) discard;
    gl_SampleMask[0] = covered;
    if (!gl_FrontFacing) {
        s.normal = -s.normal;
        s.geometric_normal = s.normal;
    }
    if (look.material != kNoLook) modelMaterial(s, look, laid);
#endif
    turnToEye(s);
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
