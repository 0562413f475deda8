// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A square of the floor plane y = 0 round the camera, as far as it can see; for the id picture.
#include "common/frame.glsl"

void main() {
    float reach = kFloorReach * frame.depth_range.y;
    vec2 corner = vec2(gl_VertexID >> 1, gl_VertexID & 1) * 2.0 - 1.0;  // counter-clockwise from above, as a strip
    vec3 position = vec3(frame.eye.x + reach * corner.x, 0.0, frame.eye.z + reach * corner.y);
    gl_Position = frame.view_projection * vec4(position, 1.0);
}
