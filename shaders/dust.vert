// SPDX-License-Identifier: Apache-2.0
#version 450 core
// The square about a puff that faces the picture, and how much of the sun the puff sees.
#include "common/frame.glsl"
#include "common/puff.glsl"
layout(binding = 1) uniform sampler2D shadow_depth;
#ifdef FULL
#include "common/dust_shadow.glsl"
#endif
out vec2 corner;
out vec3 across;  // m, from the middle
flat out vec4 centre_radius;
flat out vec3 depth_age_heat;
flat out float sunlit;

const int kTaps = 6;

// Of six points in it, in the near region of the shadow map.
float shareInSun(vec4 puff) {
    float lit = 0.0;
    for (int k = 0; k < kTaps; ++k) {
        vec3 off = 0.6 * puff.w * (vec3(k % 3, k / 3, (k * 2) % 3) - vec3(1.0, 0.5, 1.0));
        vec3 p = (frame.light_matrix[0] * vec4(puff.xyz + off, 1.0)).xyz;
        bool held = all(lessThan(abs(p - 0.5), vec3(0.5)));
        lit += float(!held || p.z <= textureLod(shadow_depth, vec2(0.5 * p.x, p.y), 0.0).r + 5e-4);
    }
    return lit / float(kTaps);
}

// Dust that drifts is drawn out: along a direction of its own a puff is longer by the root of 1 + kStretch, and across it
// narrower by as much.
const float kStretch = 2.0;

// Its axes as the picture shows them, in radii.
mat2x3 axesOf(Puff p) {
    vec3 right = normalize(frame.ray_right.xyz), up = normalize(frame.ray_up.xyz);
    vec2 draw = unpackUnorm2x16(p.seed);
    float height = 2.0 * draw.x - 1.0, turn = 6.2831853 * draw.y, width = sqrt(1.0 - height * height);
    vec3 drawn = vec3(width * cos(turn), height, width * sin(turn));
    vec2 seen = vec2(dot(drawn, right), dot(drawn, up));
    float square = dot(seen, seen), stretch = sqrt(1.0 + kStretch * square);
    vec2 along = square > 1e-6 ? inversesqrt(square) * seen : vec2(1.0, 0.0);
    return mat2x3(stretch * (along.x * right + along.y * up), (along.x * up - along.y * right) / stretch);
}

void main() {
    Puff p = puffs[gl_InstanceID];
    corner = squareCorner(gl_VertexID);
    centre_radius = p.position_radius;
    depth_age_heat = vec3(p.depth, p.age, p.heat);
    sunlit = 0.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
    if (p.position_radius.w <= 0.0) return;
    sunlit = shareInSun(p.position_radius);
#ifdef FULL
    sunlit *= throughDust((frame.light_matrix[0] * vec4(p.position_radius.xyz, 1.0)).xyz);
#endif
    across = p.position_radius.w * (axesOf(p) * corner);
    gl_Position = frame.view_projection * vec4(p.position_radius.xyz + across, 1.0);
}
