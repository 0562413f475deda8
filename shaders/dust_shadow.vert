// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A puff as the sun sees it, in the near region of its map: a point, which costs a quarter of a square's corners.
// One whose middle lies outside the region is not drawn.
#include "common/frame.glsl"
#include "common/puff.glsl"
layout(location = 0) uniform float texels;  // along a side of the sums
flat out vec2 depth;                        // optical, and in the region

void main() {
    Puff p = puffs[gl_VertexID];
    vec3 at = (frame.light_matrix[0] * vec4(p.position_radius.xyz, 1.0)).xyz;
    depth = vec2(p.depth, at.z);
    float radius = p.position_radius.w / frame.shadow[0].z;
    gl_PointSize = 2.0 * radius * texels;
    gl_Position = radius > 0.0 ? vec4(2.0 * at.xy - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
