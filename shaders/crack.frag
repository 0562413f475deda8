// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The dark inside of a crack (common/crack_cover.glsl).
#include "common/noise.glsl"
#include "common/crack_cover.glsl"
in vec3 place;
in float half_width;
in float strength;
in float slant;
in vec3 rest;
layout(location = 0) out vec4 material_out;

void main() {
    CrackPlace at = CrackPlace(place.x, place.y, place.z);
    float ragged = noise(rest, 1.0 / noise_shape.x).w;
    material_out = vec4(kCrackColour, crackCover(at, half_width, strength, slant, ragged));
}
