// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Depth, but for what is cut out of the body.
#include "common/model_looks.glsl"
#include "common/drawn_look.glsl"

void main() {
    if (isCutOut(drawnLook(), drawnLaid(vec3(0.0)))) discard;
}
