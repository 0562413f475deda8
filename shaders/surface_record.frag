// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The material of a body's surface, as surface.frag makes it, of what a pixel shows of a small triangle: each pixel drawn here is
// a record (engine/render/surface_records.h). INTERIOR: of broken faces.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/rotate.glsl"
#define COMPUTED
#include "common/noise.glsl"
#define BODY_MATERIAL 8
#include "common/body_material.glsl"
layout(binding = 3) uniform usampler2D records;  // four texels each
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;

uvec4 texelOf(ivec2 record, int k) { return texelFetch(records, ivec2(4 * record.x + k, record.y), 0); }

void main() {
    ivec2 record = ivec2(gl_FragCoord.xy);
    uvec4 a = texelOf(record, 0), b = texelOf(record, 1), c = texelOf(record, 2), d = texelOf(record, 3);
    vec3 rest = uintBitsToFloat(a.xyz), right = uintBitsToFloat(c.xyz), up = uintBitsToFloat(d.xyz);
    Surface s;
    s.position = frame.eye.xyz + rayThrough(vec2(b.w & 0xffffu, b.w >> 16) + 0.5);
    s.geometric_normal = decodeOctahedral(unpackSnorm2x16(a.w));
    s.normal = s.geometric_normal;
    s.metalness = 0.0;
    noise_footprint = max(length(right), length(up));
#ifdef INTERIOR
    vec4 rotation = vec4(unpackSnorm2x16(b.x), unpackSnorm2x16(b.y));
    vec2 relief = unpackHalf2x16(b.z), deeper = uintBitsToFloat(uvec2(c.w, d.w));
    insideMaterial(s, rest, rotation, relief, coatAt(relief.x, right, up, deeper));
#else
    outsideMaterial(s, rest);
#endif
    turnToEye(s);
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
