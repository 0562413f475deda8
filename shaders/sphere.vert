// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The square that touches the sphere's front and covers its outline as the camera sees it.
#include "common/frame.glsl"
#include "common/sphere.glsl"
out vec3 on_square;
flat out vec4 centre_radius;
flat out float value;
flat out uint fragment_slot;

void main() {
    Sphere s = spheres[gl_InstanceID];
    vec3 to_centre = s.position_radius.xyz - frame.eye.xyz;
    float r = s.position_radius.w;
    float distance = max(length(to_centre), 1.001 * r);
    vec3 axis = to_centre / distance;
    float front = max(distance - r, frame.depth_range.x);
    // The outline's cone has tangent r / sqrt(d^2 - r^2); a pixel more leaves room for smooth edges.
    float pixel = 2.0 * frame.depth_range.z * frame.viewport.w * distance;
    float half_size = front * (r + pixel) / sqrt(max(distance * distance - r * r, 1e-12));
    vec3 side = normalize(cross(abs(axis.y) < 0.99 ? vec3(0, 1, 0) : vec3(1, 0, 0), axis));
    vec3 up = cross(axis, side);
    vec2 corner = vec2(2 * (gl_VertexID >> 1) - 1, 2 * (gl_VertexID & 1) - 1);
    on_square = frame.eye.xyz + axis * front + half_size * (corner.x * side + corner.y * up);
    centre_radius = s.position_radius;
    value = s.value;
    fragment_slot = s.fragment_slot;
    gl_Position = frame.view_projection * vec4(on_square, 1.0);
}
