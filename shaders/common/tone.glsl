// SPDX-License-Identifier: Apache-2.0
// From light to display: a film-like curve and the sRGB encoding.
#include "common/srgb.glsl"
// Bright saturated colours lean to white, as film does: primaries are mixed a little before the curve and unmixed after.
const float kMix = 0.09;

// `curve`: contrast, shoulder, b, c; y = x^contrast gives y / (y^shoulder b + c).
vec3 toneMap(vec3 c, vec4 curve) {
    c *= frame.sun_colour.w;
    float mean = (c.r + c.g + c.b) / 3.0;
    c = max(mix(c, vec3(mean), kMix), 1e-5);
    vec3 x = curve.x * log2(c);  // exponents of two: one logarithm serves both powers
    c = exp2(x) / (exp2(curve.y * x) * curve.z + curve.w);
    mean = (c.r + c.g + c.b) / 3.0;
    return clamp(mean + (c - mean) / (1.0 - 0.75 * kMix), 0.0, 1.0);
}
