// SPDX-License-Identifier: Apache-2.0
// GGX metallic-roughness reflection of one sun and the sky.
float ggxSpecular(float n_dot_h, float n_dot_v, float n_dot_l, float roughness) {
    float a = roughness * roughness;
    float a2 = a * a;
    float d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
    float distribution = a2 / (3.14159265 * d * d);
    // Height-correlated Smith visibility, already divided by 4 n.l n.v.
    float masking = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - a2) + a2);
    float shadowing = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - a2) + a2);
    return distribution * 0.5 / max(masking + shadowing, 1e-5);
}

float fifthPower(float x) {
    float x2 = x * x;
    return x2 * x2 * x;
}

// What scatters, over a Lambertian surface: a rough one that is grazed sends more back to where light comes from, a smooth one
// less, since that mirrors it (Burley 2012).
float roughScattering(float n_dot_l, float n_dot_v, float l_dot_h, float roughness) {
    float grazed = 2.0 * roughness * l_dot_h * l_dot_h - 0.5;
    return (1.0 + grazed * fifthPower(1.0 - n_dot_l)) * (1.0 + grazed * fifthPower(1.0 - n_dot_v));
}

vec3 fresnel(vec3 f0, float cosine) {
    return f0 + (clamp(50.0 * f0, 0.0, 1.0) - f0) * fifthPower(1.0 - cosine);
}

// Share of the environment that is mirrored (fit of the split-sum integral, Karis 2014).
vec3 environmentShare(vec3 f0, float roughness, float n_dot_v) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a004 = min(r.x * r.x, exp2(-9.28 * n_dot_v)) * r.x + r.y;
    vec2 scale_bias = vec2(-1.04, 1.04) * a004 + r.zw;
    return f0 * scale_bias.x + scale_bias.y * clamp(50.0 * f0, 0.0, 1.0);
}
