// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The dark inside of a crack (common/crack_cover.glsl).
#include "common/noise.glsl"
#include "common/crack_cover.glsl"
in float across;
in float half_width;
in float strength;
in vec3 rest;
layout(location = 0) out vec4 material_out;
layout(location = 0) uniform float width;  // m

void main() { material_out = vec4(kCrackColour, crackCover(rest, width, across, half_width, strength)); }
