// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Drafts with transparent bodies, where none is: what is opaque, behind its dust.
#define SHADOW_DRAFT
#include "common/frame.glsl"
#include "common/finish.glsl"
#include "common/dust_over.glsl"
layout(binding = 15) uniform sampler2D picture;  // as common/walked_pixel.glsl has it
layout(location = 0) out vec4 colour;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 dust = dustBefore(pixel);
    colour = finished(taken(dust + (1.0 - dust.a) * texelFetch(picture, pixel, 0)));
}
