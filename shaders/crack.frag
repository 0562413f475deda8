// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The dark inside of a crack (common/crack_cover.glsl).
#include "common/crack_cover.glsl"
in float across;
in float half_width;
in float strength;
layout(location = 0) out vec4 material_out;

void main() { material_out = vec4(kCrackColour, crackCover(across, half_width, strength)); }
