// SPDX-License-Identifier: Apache-2.0
// Soft sun shadow: blockers are looked for first, the penumbra grows with their distance (percentage-closer soft shadows).
layout(binding = 1) uniform sampler2D shadow_depth;
#if defined(COMPUTED) || defined(EMPTY)
#define COARSE_SHADOWS
// No depth format can be written by a compute pass, so that texels are compared and blended here.
float litTap(vec3 p) {
    vec2 size = vec2(textureSize(shadow_depth, 0)), at = p.xy * size - 0.5, first = floor(at), f = at - first;
    vec4 lit = vec4(greaterThanEqual(textureGather(shadow_depth, (first + 1.0) / size), vec4(p.z)));
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}
#else
layout(binding = 0) uniform sampler2DShadow shadow_compare;
float litTap(vec3 p) { return texture(shadow_compare, p); }
#endif

#ifndef SHADOW_TAPS
#define SHADOW_TAPS 20
#endif
const int kBlockerTaps = 24;

// Points spread evenly over the unit disc (Vogel): from one to the next they turn by the golden angle.
const mat2 kNextPoint = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

// The map holds two square regions side by side: the near one fine, round the scene; the far one coarse, for pieces that
// flew off (engine/render/frame_uniforms.cpp).
struct Region {
    float texel;  // m
    float shift;  // to the region's place in the map
    float width;  // m
    float depth;  // m, range
};

// `p`: u, v in the region, 0..1.
vec2 inMap(Region region, vec2 p) { return vec2(0.5 * (p.x + region.shift), p.y); }

// Widest penumbra, in texels.
#ifdef SHADOW_DRAFT
const float kWidest = 2.0;
#else
const float kWidest = 40.0;
#endif

// Is a point (u, v, depth) in a region, and so far inside that no tap leaves it?
bool isHeld(vec3 p) {
    float margin = (kWidest + 2.0) * frame.shadow[0].y;
    return all(lessThan(abs(p - 0.5), vec3(0.5 - margin, 0.5 - margin, 0.5)));
}

// Depth of the receiver's own plane changes under the disc; the slope keeps wide discs free of self-shadowing.
// `normal`: along u, v and depth.
vec2 receiverSlope(Region region, vec3 normal) {
    float away = min(normal.z, -0.15);  // the plane faces the light, so its normal points against the depth axis
    return clamp(-normal.xy / away, -4.0, 4.0) * region.width / region.depth;
}

// Nothing drawn lies beyond a region's far end, where receivers may: they stay just before it.
const float kFarEnd = 0.9999;

float receiverDepth(float depth, vec2 slope, vec2 offset) { return min(depth + dot(slope, offset), kFarEnd); }

#ifdef SHADOW_DRAFT
float litShare(Region region, vec3 p) {
    float lit = 0.0;
    for (int k = 0; k < 4; ++k) {
        vec2 offset = (vec2(k & 1, k >> 1) - 0.5) * 1.5 * region.texel / region.width;
        lit += litTap(vec3(inMap(region, p.xy + offset), p.z));
    }
    return 0.25 * lit;
}
#else
#ifdef COARSE_SHADOWS
layout(binding = 7) uniform sampler2D shadow_coarse;  // least depth of squares of kCoarseTexels
const float kCoarseTexels = 64.0;

// Does nothing in the squares round a point lie nearer to the sun than what surrounds it on its own plane?
bool isInTheClear(Region region, vec3 p, vec2 slope, float search) {
    float reach = search + region.texel / region.width, squares = 0.5 * float(textureSize(shadow_coarse, 0).x);
    vec2 most = vec2(squares - 1.0);
    ivec2 first = ivec2(clamp((p.xy - reach) * squares, vec2(0.0), most)), last = ivec2(clamp((p.xy + reach) * squares, vec2(0.0), most));
    float nearest = 1.0;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            nearest = min(nearest, texelFetch(shadow_coarse, ivec2(x + int(region.shift * squares), y), 0).r);
        }
    }
    return min(p.z + length(slope) * reach, kFarEnd) <= nearest;
}
#endif

float litShare(Region region, vec3 p, vec2 slope, float angle) {
    float texel = region.texel;
    float search = clamp(0.8 * frame.scene.w * frame.to_sun.w, 3.0 * texel, kWidest * texel) / region.width;
#ifdef COARSE_SHADOWS
    if (isInTheClear(region, p, slope, search)) return 1.0;
#endif
    float blocker_sum = 0.0, blockers = 0.0, hidden = 0.0;
    vec2 start = vec2(cos(angle), sin(angle)), direction = start;
    for (int k = 0; k < kBlockerTaps; ++k, direction = kNextPoint * direction) {
        // Closer together near the middle, where the blockers of small things on the floor are.
        vec2 offset = search * (float(k) + 0.5) / float(kBlockerTaps) * direction;
        float depth = texture(shadow_depth, inMap(region, p.xy + offset)).r;
        float gap = receiverDepth(p.z, slope, offset) - depth;
        // A blocker counts where it covers part of the sun: the nearer it is, the closer it must stand.
        float reach = max(gap * region.depth * frame.to_sun.w, 2.0 * texel);
        hidden += float(gap > 0.0);
        if (gap > 0.0 && length(offset) * region.width <= reach) {
            blocker_sum += depth;
            blockers += 1.0;
        }
    }
    if (blockers == 0.0) return 1.0;
    float gap = (p.z - blocker_sum / blockers) * region.depth;  // m
    float radius = clamp(gap * frame.to_sun.w, 1.2 * texel, kWidest * texel) / region.width;
    if (hidden == float(kBlockerTaps) && radius <= search) return 0.0;  // deep in the shadow
    float lit = 0.0;
    direction = start;
    for (int k = 0; k < SHADOW_TAPS; ++k, direction = kNextPoint * direction) {
        vec2 offset = radius * sqrt((float(k) + 0.5) / float(SHADOW_TAPS)) * direction;
        lit += litTap(vec3(inMap(region, p.xy + offset), receiverDepth(p.z, slope, offset)));
    }
    return lit / float(SHADOW_TAPS);
}
#endif

#ifdef SHADOW_DRAFT
float throughDust(vec3 p) { return 1.0; }
#else
#include "common/dust_shadow.glsl"
#endif

// 1 in the sun, 0 in full shadow. `normal` is the geometric one.
float sunVisibility(vec3 position, vec3 normal, vec2 pixel) {
    float facing = dot(normal, frame.to_sun.xyz);
    if (facing <= 0.0) return 0.0;
    vec3 p = (frame.light_matrix[0] * vec4(position, 1.0)).xyz;
    float clear = throughDust(p);
    bool near = isHeld(p);
    if (!near) p = p * frame.to_far_scale.xyz + frame.to_far_shift.xyz;
    vec4 sizes = near ? frame.shadow[0] : frame.shadow[1];
    Region region = Region(sizes.x, near ? 0.0 : 1.0, sizes.z, sizes.w);
    vec3 metres = vec3(region.width, region.width, region.depth);
    vec3 across = mat3(frame.light_matrix[0]) * normal * vec3(frame.shadow[0].zz, frame.shadow[0].w);  // unit again
    p += across * region.texel * (0.8 + 1.6 * (1.0 - facing)) / metres;
    p.z = min(p.z, kFarEnd) - 0.5 * region.texel / region.depth;
#ifdef SHADOW_DRAFT
    float lit = litShare(region, p);
#else
    float lit = litShare(region, p, receiverSlope(region, across), 6.2831853 * pixelNoise(pixel));
#endif
    return clear * (near || isHeld(p) ? lit : 1.0);
}
