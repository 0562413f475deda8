// SPDX-License-Identifier: Apache-2.0
// From light to display: a tone curve (engine/scene/tone_curve.h) and the sRGB encoding.
#include "common/srgb.glsl"
layout(location = 0) uniform vec4 curve;
layout(location = 16) uniform vec4 curve_more;

#if TONE == TONE_FILM || TONE == TONE_AGX
#if TONE == TONE_FILM
// Bright saturated colours lean to white, as film does: primaries are mixed a little before the curve and
// unmixed after.
const float kMix = 0.09, kUnmix = 0.75 * kMix;

vec3 curved(vec3 c) {
    vec3 x = curve.x * log2(c);  // exponents of two: one logarithm serves both powers
    return exp2(x) / (exp2(curve.y * x) * curve.z + curve.w);
}
#else
const float kMix = 0.17, kUnmix = 0.13;

vec3 curved(vec3 c) {
    vec3 x = log2(c) * curve_more.x + curve_more.y;
    vec3 bent = mix(vec3(curve.z), vec3(curve.w), greaterThanEqual(x, vec3(0.0))) * abs(x);
    vec3 y = curve_more.z + curve.x * x / pow(1.0 + pow(bent, vec3(curve.y)), vec3(1.0 / curve.y));
    return pow(clamp(y, 0.0, 1.0), vec3(2.2));
}
#endif

vec3 toneOf(vec3 c) {
    float mean = (c.r + c.g + c.b) / 3.0;
    c = curved(max(mix(c, vec3(mean), kMix), 1e-5));
    mean = (c.r + c.g + c.b) / 3.0;
    return mean + (c - mean) / (1.0 - kUnmix);
}
#elif TONE == TONE_NEUTRAL
// Only what is brighter than 0.8 is pressed, by its brightest channel, and leans to white.
vec3 toneOf(vec3 c) {
    const float kStart = 0.8 - 0.04, kRest = 1.0 - kStart;
    float least = min(c.r, min(c.g, c.b));
    c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < kStart) return c;
    float pressed = 1.0 - kRest * kRest / (peak + kRest - kStart);
    return mix(vec3(pressed), c * (pressed / peak), 1.0 / (0.15 * (peak - pressed) + 1.0));
}
#else
vec3 toneOf(vec3 c) {
    return c;
}
#endif

// `light`: times the exposure.
vec3 toneMap(vec3 light) {
    return clamp(toneOf(light), 0.0, 1.0);
}
