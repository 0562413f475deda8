// SPDX-License-Identifier: Apache-2.0
// How far a ray goes until it meets something solid, for passes that draw over the finished picture, or over a part of its size.
#include "common/floor.glsl"
#ifdef FULL
layout(binding = 4) uniform sampler2D nearest_depth;  // half the size of the picture; floor and colliders included
#else
#ifdef COLLIDERS
#include "common/colliders.glsl"
#endif
#if SAMPLES > 1
layout(binding = 4) uniform sampler2DMS depth_buffer;
#else
layout(binding = 4) uniform sampler2D depth_buffer;
#endif
#endif
layout(location = 1) uniform float pixels;  // of the picture, along one of what is drawn into

// m along the view axis to what a ray through `at` (px of the picture) meets.
float solidAlong(vec2 at, vec3 ray) {
#ifdef FULL
    return texelFetch(nearest_depth, ivec2(at * 0.5), 0).r;
#else
    float depth = texelFetch(depth_buffer, ivec2(min(at, frame.viewport.xy - 1.0)), 0).r;
    float along = min(depth > 0.0 ? linearDepth(depth) : kNoFloor, floorAlong(ray));
#ifdef COLLIDERS
    along = min(along, nearestCollider(ray).enter);
#endif
    return along;
#endif
}

