// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A puff into the sums.
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/sky.glsl"
#include "common/solid.glsl"
#include "common/puff_light.glsl"
in vec2 from_middle;
flat in SeenPuff puff;
layout(location = 0) out vec4 light_depth;

void main() {
    vec2 at = gl_FragCoord.xy * pixels;
    vec3 ray = rayThrough(at);
    light_depth = puffAlong(puff, from_middle, ray, solidAlong(at, ray));
}
