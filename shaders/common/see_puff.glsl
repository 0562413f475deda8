// SPDX-License-Identifier: Apache-2.0
// How a puff is seen, and how much of the sun it sees.
#include "common/gbuffer.glsl"
#include "common/sky.glsl"
#include "common/puff.glsl"
#include "common/seen_puff.glsl"
layout(binding = 1) uniform sampler2D shadow_depth;
layout(location = 1) uniform float pixels;  // of the picture, along one of what is drawn into
#ifdef FULL
#include "common/dust_shadow.glsl"
#endif

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

SeenPuff seenPuff(Puff p) {
    SeenPuff seen = SeenPuff(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    if (p.position_radius.w <= 0.0) return seen;
    vec4 clip = frame.view_projection * vec4(p.position_radius.xyz, 1.0);
    if (clip.w <= frame.depth_range.x) return seen;
    seen.position_radius = p.position_radius;
    float sunlit = shareInSun(p.position_radius);
#ifdef FULL
    sunlit *= throughDust((frame.light_matrix[0] * vec4(p.position_radius.xyz, 1.0)).xyz);
#endif
    seen.depth_age_heat_sunlit = vec4(p.depth, p.age, p.heat, sunlit);
    vec3 air = throughAir(vec3(0.0), p.position_radius.xyz);
    seen.air = vec4(air, (throughAir(vec3(1.0), p.position_radius.xyz) - air).g);
    vec2 middle = (0.5 * clip.xy / clip.w + 0.5) * frame.viewport.xy / pixels;
    float metres = 2.0 * frame.depth_range.z * clip.w * frame.viewport.w * pixels;  // a px

    vec2 draw = unpackUnorm2x16(p.seed);
    float height = 2.0 * draw.x - 1.0, turn = 6.2831853 * draw.y, width = sqrt(1.0 - height * height);
    vec3 drawn = vec3(width * cos(turn), height, width * sin(turn));
    vec2 way = vec2(dot(drawn, normalize(frame.ray_right.xyz)), dot(drawn, normalize(frame.ray_up.xyz)));
    float square = dot(way, way);
    seen.place = vec4(middle, metres / p.position_radius.w, sqrt(1.0 + kStretch * square));
    seen.along = vec4(square > 1e-6 ? inversesqrt(square) * way : vec2(1.0, 0.0), 0.0, 0.0);
    return seen;
}
