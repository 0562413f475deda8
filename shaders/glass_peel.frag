// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The nearest face of a transparent body behind those that were peeled off before.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/rotate.glsl"
#include "common/glass_layer.glsl"
layout(location = 0) uniform vec2 noise_shape;  // first wavelength m, strength
layout(location = 1) uniform int first;
layout(binding = 3) uniform usampler2D previous;
#if SAMPLES > 1
layout(binding = 7) uniform sampler2DMS opaque_depth;
#else
layout(binding = 7) uniform sampler2D opaque_depth;
#endif
in vec3 world_position;
in vec3 world_normal;
in vec3 rest;
flat in vec4 rotation;
#ifdef INTERIOR
in vec2 relief;
#endif
layout(location = 0) out uvec2 layer_out;

const float kSame = 2e-6;  // of a depth: faces that near lie in one
const float kFlat = 0.85;  // or cells look like drops

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = gl_FragCoord.z;
    if (first == 0 && depth >= uintBitsToFloat(texelFetch(previous, at, 0).r) * (1.0 - kSame)) discard;
    if (depth <= texelFetch(opaque_depth, at / ACROSS, 0).r) discard;
    GlassLayer layer;
    layer.depth = depth;
    layer.normal = normalize(world_normal);
    layer.enters = gl_FrontFacing;
    layer.broken = false;
#ifdef INTERIOR
    vec3 even = cross(dFdx(world_position), dFdy(world_position));
    even = normalize(dot(even, layer.normal) < 0.0 ? -even : even + vec3(0.0, 1e-20, 0.0));
    vec3 slope = rotate(rotation, fractureNoise(rest, 1.0 / noise_shape.x).xyz);
    slope -= even * dot(slope, even);
    layer.normal = normalize(mix(layer.normal, even, kFlat) - noise_shape.y * slope);
    layer.broken = true;
#endif
    layer_out = packLayer(layer);
}
