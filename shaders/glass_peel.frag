// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The nearest face of a transparent body behind those that were peeled off before.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/rotate.glsl"
#include "common/glass_layer.glsl"
#define GLASS_NOISE 0
#include "common/glass_relief.glsl"
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

const float kRounding = 2e-6;  // of a normal that is the same at all corners

void main() {
    bool curved = any(greaterThan(fwidth(world_normal), vec3(kRounding)));  // while all lanes are there
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = gl_FragCoord.z;
    if (first == 0 && !isBehind(depth, uintBitsToFloat(texelFetch(previous, at, 0).r))) discard;
    if (depth <= texelFetch(opaque_depth, at / ACROSS, 0).r) discard;
    GlassLayer layer;
    layer.depth = depth;
    layer.normal = normalize(world_normal);
    layer.enters = gl_FrontFacing;
    layer.broken = false;
    layer.curved = curved;
#ifdef INTERIOR
    layer.normal = brokenNormal(layer.normal, cross(dFdx(world_position), dFdy(world_position)), rest, rotation);
    layer.broken = true;
    layer.curved = false;
#endif
    layer_out = packLayer(layer);
}
