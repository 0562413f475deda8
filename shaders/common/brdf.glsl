// SPDX-License-Identifier: Apache-2.0
// What a surface mirrors of one sun and the sky (GGX, metallic-roughness), and how it scatters the sun's light.
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

// Unit: out of which most of what a rough surface mirrors comes, nearer to its normal than where a mirror shows it (fit of
// Lagarde and de Rousiers 2014).
vec3 mainMirrored(vec3 normal, vec3 to_eye, float roughness) {
    float smoothed = 1.0 - roughness * roughness;
    return normalize(mix(normal, reflect(-to_eye, normal), smoothed * (sqrt(smoothed) + roughness * roughness)));
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

// Share of the environment that is mirrored: f0 * x + y is within 0.027, and 0.004 in the mean, of the integral of the above
// over all directions at an f0 of 0.04 (own fit).
vec2 mirroredShares(float roughness, float n_dot_v) {
    vec4 r = vec4(1.0, roughness, roughness * roughness, roughness * roughness * roughness);
    vec2 at_0 = vec2(dot(r, vec4(0.027, 1.537, -0.607, -0.055)), dot(r, vec4(0.049, -2.171, -9.207, 7.026)));
    vec2 first = vec2(dot(r.xyz, vec3(3.038, -4.24, -0.106)), dot(r.xyz, vec3(-5.686, 14.915, -17.497)));
    vec2 second = vec2(dot(r.xy, vec2(-2.577, 2.876)), dot(r.xy, vec2(-12.63, 9.618))), third = vec2(0.481, 1.784);
    vec2 shares = ((third * n_dot_v + second) * n_dot_v + first) * n_dot_v + at_0;
    return vec2(clamp(shares.x, 0.0, 1.0), exp2(shares.y));
}
vec3 environmentShare(vec3 f0, float roughness, float n_dot_v) {
    vec2 shares = mirroredShares(roughness, n_dot_v);
    return f0 * shares.x + shares.y * clamp(50.0 * f0, 0.0, 1.0);
}
