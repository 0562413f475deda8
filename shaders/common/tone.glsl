// From light to display: a film-like curve and the sRGB encoding.
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

vec3 encodeSrgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
