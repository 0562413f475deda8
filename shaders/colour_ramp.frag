// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The scale of the particle view, 0 left and 1 right, as it is before light falls on it.
#include "common/colour_maps.glsl"
#include "common/srgb.glsl"
layout(location = 0) uniform float width;  // px
layout(location = 0) out vec4 colour;

void main() { colour = vec4(encodeSrgb(rampColour(gl_FragCoord.x / width)), 1.0); }
