// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A collider of triangles: as other colliders, or of steel.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/collider_surface.glsl"
#include "common/ball_material.glsl"
layout(location = 1) uniform vec4 place;  // as collider_triangles.vert has it
layout(location = 4) uniform vec4 colour;  // as common/colliders.glsl has it
in vec3 world_position;
in vec3 world_normal;
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;

void main() {
    Surface s = colliderSurface(world_position, normalize(world_normal), colour, linearDepth(gl_FragCoord.z));
    if (place.w > 0.0) {
        s.normal = s.geometric_normal;
        s.albedo = kBallAlbedo;
        s.roughness = kBallRoughness;
        s.metalness = 1.0;
    }
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
