// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Horizon-based ambient occlusion: in a few slices through the view direction, how high neighbours rise on both sides;
// the cosine-weighted open arc between the horizons is exact per slice (Jimenez et al. 2016, "Practical real-time
// strategies for accurate indirect occlusion", eq. 7).
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
layout(binding = 0) uniform sampler2D linear_depth;
layout(rg16f, binding = 0) writeonly uniform image2D result;
layout(location = 0) uniform float reach;  // m

const int kSlices = 3, kSteps = 5;
const float kPi = 3.14159265;

ivec2 size;

vec3 viewPosition(ivec2 p) {
    p = clamp(p, ivec2(0), size - 1);
    float depth = texelFetch(linear_depth, p, 0).r;
    vec2 ndc = (2.0 * (2.0 * vec2(p) + 1.0) * frame.viewport.zw) - 1.0;
    return vec3(ndc * frame.depth_range.z * vec2(frame.depth_range.w, 1.0), -1.0) * depth;
}

vec3 shorter(vec3 a, vec3 b) { return abs(a.z) < abs(b.z) ? a : b; }

// Surface normal from whichever neighbour on each axis belongs to the same surface.
vec3 viewNormal(ivec2 p, vec3 centre) {
    vec3 right = viewPosition(p + ivec2(1, 0)) - centre, left = centre - viewPosition(p - ivec2(1, 0));
    vec3 above = viewPosition(p + ivec2(0, 1)) - centre, below = centre - viewPosition(p - ivec2(0, 1));
    vec3 across = p.x == 0 ? right : p.x == size.x - 1 ? left : shorter(right, left);
    vec3 upward = p.y == 0 ? above : p.y == size.y - 1 ? below : shorter(above, below);
    return normalize(cross(across, upward));
}

// Highest cosine to the view direction along one half of a slice.
float horizon(ivec2 p, vec3 centre, vec3 to_eye, vec2 direction, float radius_px, float start) {
    float highest = -1.0;
    for (int k = 0; k < kSteps; ++k) {
        float share = (float(k) + start) / float(kSteps);
        vec2 offset = direction * max(radius_px * share * share, float(k + 1));
        vec3 delta = viewPosition(p + ivec2(round(offset))) - centre;
        float distance = length(delta);
        float fade = clamp(2.0 - 2.0 * distance / reach, 0.0, 1.0);  // far things, even if high, do not shade
        highest = max(highest, mix(-1.0, dot(delta, to_eye) / max(distance, 1e-6), fade));
    }
    return highest;
}

float openArc(float h, float n) { return 0.25 * (-cos(2.0 * h - n) + cos(n) + 2.0 * h * sin(n)); }

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    size = textureSize(linear_depth, 0);
    if (any(greaterThanEqual(p, size))) return;
    vec3 centre = viewPosition(p);
    float depth = -centre.z;
    float radius_px = 0.25 * reach * frame.viewport.y / (frame.depth_range.z * depth);
    if (depth > 0.98 * frame.depth_range.y || radius_px < 1.0) {
        imageStore(result, p, vec4(1.0, depth, 0.0, 0.0));
        return;
    }
    radius_px = min(radius_px, 0.2 * float(size.y));
    vec3 to_eye = normalize(-centre);
    vec3 normal = viewNormal(p, centre);
    // Sixteen turns in blocks of 4 x 4, which the blur averages out.
    int cell = (p.x & 3) + 4 * (p.y & 3);
    float turn = float((cell * 7) & 15) / 16.0;
    float start = 0.35 + 0.65 * float((cell * 11 + 5) & 15) / 16.0;
    float visible = 0.0;
    for (int slice = 0; slice < kSlices; ++slice) {
        float angle = kPi * (float(slice) + turn) / float(kSlices);
        vec2 direction = vec2(cos(angle), sin(angle));
        vec3 tangent = vec3(direction, 0.0) - to_eye * dot(vec3(direction, 0.0), to_eye);
        vec3 slice_normal = normalize(cross(tangent, to_eye));
        vec3 projected = normal - slice_normal * dot(normal, slice_normal);
        float weight = length(projected);
        float n = sign(dot(tangent, projected)) * acos(clamp(dot(projected, to_eye) / max(weight, 1e-5), -1.0, 1.0));
        float right = acos(horizon(p, centre, to_eye, direction, radius_px, start));
        float left = -acos(horizon(p, centre, to_eye, -direction, radius_px, start));
        right = n + min(right - n, 0.5 * kPi);
        left = n + max(left - n, -0.5 * kPi);
        visible += weight * (openArc(right, n) + openArc(left, n));
    }
    visible = clamp(visible / float(kSlices), 0.0, 1.0);
    visible = mix(1.0, visible, smoothstep(1.0, 6.0, radius_px));  // too few pixels to tell a neighbour from noise
    imageStore(result, p, vec4(visible, depth, 0.0, 0.0));
}
