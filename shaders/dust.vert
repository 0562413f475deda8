// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The parallelogram about a puff that faces the picture.
#include "common/frame.glsl"
#include "common/see_puff.glsl"
out vec2 from_middle;  // radii
flat out SeenPuff puff;

void main() {
    puff = seenPuff(puffs[gl_InstanceID]);
    from_middle = vec2(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
    if (puff.position_radius.w <= 0.0) return;
    vec2 corner = squareCorner(gl_VertexID), way = puff.along.xy;
    from_middle = puff.place.w * corner.x * way + corner.y / puff.place.w * vec2(-way.y, way.x);
    vec3 across = from_middle.x * normalize(frame.ray_right.xyz) + from_middle.y * normalize(frame.ray_up.xyz);
    gl_Position = frame.view_projection * vec4(puff.position_radius.xyz + puff.position_radius.w * across, 1.0);
}
