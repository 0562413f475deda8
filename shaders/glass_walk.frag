// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The picture with what is transparent, drawn (common/walked_pixel.glsl).
#include "common/walked_pixel.glsl"
layout(location = 0) out vec4 colour;

void main() { colour = pixelWalked(ivec2(gl_FragCoord.xy)); }
