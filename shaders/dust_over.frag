// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Dust over the finished picture: premultiplied display colour, and how much of the picture it hides.
#include "common/frame.glsl"
#include "common/tone.glsl"
layout(binding = 5) uniform sampler2D light_depth;  // sums of dust.frag, smaller than the picture
layout(location = 0) uniform vec4 curve;
layout(location = 1) uniform vec2 used;  // part of light_depth that is in use
layout(location = 0) out vec4 colour;

void main() {
    vec4 sum = textureLod(light_depth, gl_FragCoord.xy * frame.viewport.zw * used, 0.0);
    if (sum.a < 1e-4) discard;
    float hidden = 1.0 - exp(-sum.a);
    colour = vec4(encodeSrgb(toneMap(sum.rgb / sum.a, curve)) * hidden, hidden);
}
