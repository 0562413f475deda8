// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A transparent body as the sun sees it, in the near region of its map.
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
#include "common/gbuffer.glsl"
layout(location = 0) in vec3 rest_position;
layout(location = 1) in vec2 rest_normal;
layout(location = 2) in uint cell;
out vec3 normal;
out vec3 position;  // m

void main() {
    FragmentTransform t = transforms[particle_fragment[cell]];
    vec3 world = moved(t, rest_position);
    normal = rotate(t.rotation, decodeOctahedral(rest_normal));
    position = world;
    gl_Position = unlessHidden(vec4(2.0 * (frame.light_matrix[0] * vec4(world, 1.0)).xy - 1.0, 0.5, 1.0), cell);
}
