// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Exact sphere; the outline is smoothed by covering as many samples as the pixel's share inside.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/sphere_hit.glsl"
#include "common/colour_maps.glsl"
#include "common/ball_material.glsl"
layout(depth_less) out float gl_FragDepth;  // the square lies in front of every point of the sphere
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;
layout(location = 0) uniform int colour_map;  // engine::ColourMap, or kMetal
const int kMetal = 4;

void main() {
    vec3 ray = normalize(on_square - frame.eye.xyz);
    float inside = sphereDepth(ray);
    float covered = clamp(inside / max(fwidth(inside), 1e-6) + 0.5, 0.0, 1.0);
    int samples = int(covered * float(gl_NumSamples) + 0.5);
    if (samples == 0) discard;
    gl_SampleMask[0] = (1 << samples) - 1;

    Surface s;
    s.position = sphereHit(ray, inside);
    s.normal = normalize(s.position - centre_radius.xyz);
    s.geometric_normal = s.normal;
    gl_FragDepth = clipDepth(s.position);
    if (colour_map == kMetal) {
        s.albedo = kBallAlbedo;
        s.roughness = kBallRoughness;
        s.metalness = 1.0;
    } else {
        s.albedo = colour_map == 0 ? fragmentColour(fragment_slot) : rampColour(value);
        s.roughness = 0.55;
        s.metalness = 0.0;
    }
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
