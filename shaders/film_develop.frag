// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The mean of all pictures, mapped to the display: sRGB encoded, alpha straight.
#include "common/choices.glsl"
#include "common/tone.glsl"
layout(binding = 0) uniform sampler2D sum;   // radiance times alpha, and alpha
layout(location = 1) uniform vec4 exposure;  // rgb: factors; w: 1 / number of pictures
layout(location = 0) out vec4 colour;

void main() {
    vec4 mean = texelFetch(sum, ivec2(gl_FragCoord.xy), 0) * exposure.w;
    float alpha = clamp(mean.a, 0.0, 1.0);
    colour = vec4(encodeSrgb(toneMap(mean.rgb / max(mean.a, 1e-4) * exposure.rgb)), alpha);
}
