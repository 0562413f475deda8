// SPDX-License-Identifier: Apache-2.0
// How ragged the sides of a crack are: after common/noise.glsl and common/crack_cover.glsl.
const float kWidens = 0.7, kWanders = 0.35;  // of the noise's value, of its slope across the line

// -1..1 on the left and on the right of a line, by the broken material's noise at a place that is `at` at rest, m. What
// follows in another direction, with left and right exchanged, is ragged alike.
vec2 raggedAt(vec3 at, vec3 left) {
    vec4 n = noise(at, 1.0 / noise_shape.x);
    float wanders = kWanders * dot(n.xyz, left);
    return clamp(kWidens * n.w + vec2(wanders, -wanders), -1.0, 1.0);
}
