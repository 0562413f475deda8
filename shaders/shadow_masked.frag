// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Depth, but for what is cut out of the body or let through.
#include "common/frame.glsl"
#include "common/model_looks.glsl"
#include "common/drawn_look.glsl"
#include "common/model_holes.glsl"
in vec3 rest;

void main() {
    if (coveredSamples(drawnLook(), drawnLaid(vec3(0.0))) == 0) discard;
}
