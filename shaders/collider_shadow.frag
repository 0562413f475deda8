// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A collider in the sun's depth map.
#include "common/frame.glsl"
#include "common/colliders.glsl"
layout(location = 0) uniform int region;
flat in uint collider;
in vec3 on_box;

void main() {
    vec3 caster;
    if (!shadowPoint(collider, on_box, caster)) discard;
    gl_FragDepth = (frame.light_matrix[region] * vec4(caster, 1.0)).z;
}
