// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The box round a collider as a strip of 14 corners: as the camera sees it, or, with SHADOW, as the sun does.
#include "common/frame.glsl"
#include "common/colliders.glsl"
#ifdef SHADOW
layout(location = 0) uniform int region;
#endif
flat out uint collider;
out vec3 on_box;  // m

void main() {
    collider = uint(gl_InstanceID);
    Collider c = colliders[collider];
    uvec3 upper = (uvec3(0x287au, 0x02afu, 0x31e3u) >> gl_VertexID) & 1u;
    vec3 corner = 2.0 * vec3(upper) - 1.0;
    on_box = c.centre.xyz;
    for (int k = 0; k < 3; ++k) on_box += corner[k] * c.axis[k].w * c.axis[k].xyz;
#ifdef SHADOW
    vec3 p = (frame.light_matrix[region] * vec4(on_box, 1.0)).xyz;
    gl_Position = vec4(p.xy * 2.0 - 1.0, p.z, 1.0);
#else
    gl_Position = frame.view_projection * vec4(on_box, 1.0);
#endif
}
