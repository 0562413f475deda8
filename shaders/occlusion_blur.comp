// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Averages the 4 x 4 pattern of the gather away, only among pixels of the same surface.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
layout(binding = 0) uniform sampler2D linear_depth;
layout(binding = 1) uniform sampler2D raw;
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(raw, 0);
    if (any(greaterThanEqual(p, size))) return;
    float depth = texelFetch(linear_depth, p, 0).r;
    // The slope of the surface itself must not stop the blur.
    float left = texelFetch(linear_depth, max(p - ivec2(1, 0), ivec2(0)), 0).r;
    float right = texelFetch(linear_depth, min(p + ivec2(1, 0), size - 1), 0).r;
    float below = texelFetch(linear_depth, max(p - ivec2(0, 1), ivec2(0)), 0).r;
    float above = texelFetch(linear_depth, min(p + ivec2(0, 1), size - 1), 0).r;
    float slope = min(abs(depth - left), abs(right - depth)) + min(abs(depth - below), abs(above - depth));
    float tolerance = 0.004 * depth + 3.0 * slope;
    float sum = 0.0, weights = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = clamp(p + ivec2(x, y), ivec2(0), size - 1);
            float edge = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0);
            float other = texelFetch(linear_depth, q, 0).r;
            float weight = edge * clamp(1.5 - abs(other - depth) / tolerance, 0.0, 1.0);
            sum += weight * texelFetch(raw, q, 0).r;
            weights += weight;
        }
    }
    imageStore(result, p, vec4(sum / max(weights, 1e-4), depth, 0.0, 0.0));
}
