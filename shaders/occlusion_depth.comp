// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Half-size linear depth of what was drawn, of the floor and of colliders: the nearest of four pixels, so that thin things keep their outline.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#include "common/floor.glsl"
#ifdef COLLIDERS
#include "common/colliders.glsl"
#endif
#ifdef COMPUTED
#include "common/visible.glsl"
float depthAt(ivec2 pixel) { return uintBitsToFloat(depthOfSample(sampleIndex(pixel, SAMPLES, 0))); }
#else
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS depth_buffer;
#else
layout(binding = 0) uniform sampler2D depth_buffer;
#endif
float depthAt(ivec2 pixel) { return texelFetch(depth_buffer, pixel, 0).r; }
#endif
layout(r32f, binding = 0) writeonly uniform image2D result;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(result)))) return;
    ivec2 last = ivec2(frame.viewport.xy) - 1;
    float nearest = frame.depth_range.y;
    for (int k = 0; k < 4; ++k) {
        ivec2 pixel = min(2 * p + ivec2(k & 1, k >> 1), last);
        vec3 ray = rayThrough(vec2(pixel) + 0.5);
        float along = min(linearDepth(depthAt(pixel)), floorAlong(ray));
#ifdef COLLIDERS
        along = min(along, nearestCollider(ray).enter);
#endif
        nearest = min(nearest, along);
    }
    imageStore(result, p, vec4(nearest));
}
