#version 450 core
// Body surface. INTERIOR: the broken material, lighter, rough, its normal bent by noise of the rest position
// (geometry.md 4a); pits are darker, as light gets lost in them, ridges and the rim paler with dust. Otherwise the
// model's own outside.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
in vec3 world_position;
in vec3 world_normal;
in vec3 rest;
flat in vec4 rotation;
#ifdef INTERIOR
in vec2 relief;  // x: 0 at the outside .. 1 deep; y: -1 pit .. 1 ridge
#endif
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;
layout(location = 0) uniform vec4 material;     // rgb albedo, a roughness
layout(location = 1) uniform vec2 noise_shape;  // first wavelength m, strength

vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void main() {
    Surface s;
    s.position = world_position;
    vec3 to_eye = normalize(frame.eye.xyz - world_position);
    s.geometric_normal = normalize(world_normal);
    s.normal = s.geometric_normal;
    s.metalness = 0.0;
#ifdef INTERIOR
    vec4 fine = fractureNoise(rest / noise_shape.x);
    float coarse = noise(rest / (noise_shape.x * 7.3)).w;
    vec3 slope = turned(rotation, fine.xyz);
    slope -= s.normal * dot(slope, s.normal);
    s.normal = normalize(s.normal - noise_shape.y * slope);
    float tint = 1.0 + 0.22 * fine.w + 0.22 * coarse;
    float pit = max(-relief.y, 0.0), dust = max(relief.y, 0.0) + 0.4 * (1.0 - relief.x);
    tint *= (1.0 - 0.55 * pit) * (1.0 + 0.12 * dust);
    s.albedo = material.rgb * tint * mix(vec3(1.0), vec3(1.04, 1.0, 0.94), coarse);
    s.roughness = clamp(material.a + 0.08 * fine.w, 0.05, 1.0);
#else
    float coarse = noise(rest / (noise_shape.x * 9.0)).w;
    float speck = noise(rest / (noise_shape.x * 1.7)).w;
    s.albedo = material.rgb * (1.0 + 0.05 * coarse + 0.03 * speck);
    s.roughness = clamp(material.a * (1.0 + 0.18 * coarse), 0.05, 1.0);
#endif
    // An interpolated normal may point away at the silhouette, where the surface itself cannot.
    float facing = dot(s.normal, to_eye);
    if (facing < 0.02) s.normal = normalize(s.normal + (0.02 - facing) * to_eye);
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
