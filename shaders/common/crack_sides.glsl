// SPDX-License-Identifier: Apache-2.0
// How ragged the sides of a crack are: after common/noise.glsl and common/crack_cover.glsl.
const vec3 kOtherSide = vec3(7.3, 3.1, 5.7);  // in wavelengths: each side has its own

// -1..1 on the left and on the right of a line, the broken material's noise at a place that is `at` at rest, m.
vec2 raggedAt(vec3 at) {
    return vec2(noise(at, 1.0 / noise_shape.x).w, noise(at + noise_shape.x * kOtherSide, 1.0 / noise_shape.x).w);
}
