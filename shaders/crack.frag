// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The inside of a crack (common/crack_cover.glsl).
#include "common/noise.glsl"
#include "common/crack_cover.glsl"
#include "common/crack_sides.glsl"
in vec3 place;
in float half_width;
in float strength;
in float slant;
in vec3 rest;
flat in vec3 left;  // at rest
layout(location = 6) uniform vec3 wall_colour;  // square root of the albedo
layout(location = 0) out vec4 material_out;

void main() {
    CrackPlace at = CrackPlace(place.x, place.y, place.z);
    CrackCover cover = crackCover(at, half_width, strength, slant, raggedAt(rest, left));
    material_out = vec4(crackRoot(cover, wall_colour), cover.hides);
}
