// SPDX-License-Identifier: Apache-2.0
// The broken face of a transparent body: `smooth_normal` goes round the cell, `even` is the triangle's own.
layout(location = GLASS_NOISE) uniform vec2 noise_shape;  // first wavelength m, strength

const float kFlat = 0.85;  // or cells look like drops

vec3 brokenNormal(vec3 smooth_normal, vec3 even, vec3 rest, vec4 rotation) {
    even = normalize(dot(even, smooth_normal) < 0.0 ? -even : even + vec3(0.0, 1e-20, 0.0));
    vec3 slope = rotate(rotation, fractureNoise(rest, 1.0 / noise_shape.x).xyz);
    slope -= even * dot(slope, even);
    return normalize(mix(smooth_normal, even, kFlat) - noise_shape.y * slope);
}
