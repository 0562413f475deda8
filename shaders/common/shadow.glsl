// Soft sun shadow: blockers are looked for first, the penumbra grows with their distance (percentage-closer soft shadows).
layout(binding = 0) uniform sampler2DShadow shadow_compare;
layout(binding = 1) uniform sampler2D shadow_depth;

#ifndef SHADOW_TAPS
#define SHADOW_TAPS 20
#endif
const int kBlockerTaps = 24;

// Point k of n spread evenly over the unit disc (Vogel), turned by `angle`.
vec2 discPoint(int k, int n, float angle) {
    float radius = sqrt((float(k) + 0.5) / float(n));
    float theta = 2.39996323 * float(k) + angle;
    return radius * vec2(cos(theta), sin(theta));
}

// Depth of the receiver's own plane changes under the disc; the slope keeps wide discs free of self-shadowing.
vec2 receiverSlope(vec3 normal) {
    vec3 n = mat3(frame.light_matrix) * normal;
    // light_matrix scales u, v by 1/width and depth by 1/range; a plane n.p = c in metres has dz/dx = -nx/nz.
    vec3 metres = n * vec3(frame.shadow.z, frame.shadow.z, frame.shadow.w);
    float away = min(metres.z, -0.15);  // the plane faces the light, so its normal points against the depth axis
    return clamp(-metres.xy / away, -4.0, 4.0) * frame.shadow.z / frame.shadow.w;
}

// Nothing drawn lies beyond the map's far end, where receivers may: they stay just before it.
const float kFarEnd = 0.9999;

float receiverDepth(float depth, vec2 slope, vec2 offset) { return min(depth + dot(slope, offset), kFarEnd); }

// 1 in the sun, 0 in full shadow. `normal` is the geometric one.
float sunVisibility(vec3 position, vec3 normal, vec2 pixel) {
    float facing = dot(normal, frame.to_sun.xyz);
    if (facing <= 0.0) return 0.0;
    float texel = frame.shadow.x;
    vec3 shifted = position + normal * texel * (0.8 + 1.6 * (1.0 - facing));
    vec3 p = (frame.light_matrix * vec4(shifted, 1.0)).xyz;
    if (any(lessThan(p.xy, vec2(0.0))) || any(greaterThan(p.xy, vec2(1.0)))) return 1.0;
    p.z = clamp(p.z, 0.0, kFarEnd) - 0.5 * texel / frame.shadow.w;
#ifdef SHADOW_DRAFT
    float lit = 0.0;
    for (int k = 0; k < 4; ++k) {
        vec2 offset = (vec2(k & 1, k >> 1) - 0.5) * 1.5 * frame.shadow.y;
        lit += texture(shadow_compare, vec3(p.xy + offset, p.z));
    }
    return 0.25 * lit;
#else
    vec2 slope = receiverSlope(normal);
    float angle = 6.2831853 * pixelNoise(pixel);
    float search = clamp(0.8 * frame.scene.w * frame.to_sun.w, 3.0 * texel, 40.0 * texel) / frame.shadow.z;
    float blocker_sum = 0.0, blockers = 0.0;
    for (int k = 0; k < kBlockerTaps; ++k) {
        // Closer together near the middle, where the blockers of small things on the floor are.
        float share = (float(k) + 0.5) / float(kBlockerTaps);
        vec2 offset = search * sqrt(share) * discPoint(k, kBlockerTaps, angle);
        float depth = texture(shadow_depth, p.xy + offset).r;
        // A blocker counts where it covers part of the sun: the nearer it is, the closer it must stand.
        float reach = max((receiverDepth(p.z, slope, offset) - depth) * frame.shadow.w * frame.to_sun.w, 2.0 * texel);
        if (depth < receiverDepth(p.z, slope, offset) && length(offset) * frame.shadow.z <= reach) {
            blocker_sum += depth;
            blockers += 1.0;
        }
    }
    if (blockers == 0.0) return 1.0;
    float gap = (p.z - blocker_sum / blockers) * frame.shadow.w;  // m
    float radius = clamp(gap * frame.to_sun.w, 1.2 * texel, 40.0 * texel) / frame.shadow.z;
    float lit = 0.0;
    for (int k = 0; k < SHADOW_TAPS; ++k) {
        vec2 offset = radius * discPoint(k, SHADOW_TAPS, angle);
        lit += texture(shadow_compare, vec3(p.xy + offset, receiverDepth(p.z, slope, offset)));
    }
    return lit / float(SHADOW_TAPS);
#endif
}
