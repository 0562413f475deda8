// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A collider in the id picture.
#include "common/frame.glsl"
#include "common/colliders.glsl"
layout(location = 0) uniform uint collider_id;
layout(location = 0) out uint id;
flat in uint collider;
in vec3 on_box;

void main() {
    vec3 ray = on_box - frame.eye.xyz;
    Crossing found = crossCollider(collider, frame.eye.xyz, ray);
    if (found.enter <= 0.0 || found.enter > found.leave) discard;
    vec4 clip = frame.view_projection * vec4(frame.eye.xyz + found.enter * ray, 1.0);
    gl_FragDepth = clip.z / clip.w;
    id = collider_id;
}
