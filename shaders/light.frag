// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The lit picture, drawn (common/lit_pixel.glsl).
#include "common/lit_pixel.glsl"
layout(location = 0) out vec4 colour;

void main() { colour = pixelColour(ivec2(gl_FragCoord.xy)); }
