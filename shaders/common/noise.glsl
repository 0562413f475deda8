// SPDX-License-Identifier: Apache-2.0
// Band-limited noise of rest position from a small repeating volume: rgb = gradient, a = value, both mapped to 0..1.
layout(binding = 2) uniform sampler3D noise_volume;
const float kNoisePeriod = 8.0;  // lattice cells along one side of the volume
const float kTexelsPerCell = 8.0;

// xyz: gradient per lattice cell, w: value, about -1..1. `p` in lattice cells.
vec4 noise(vec3 p) {
    vec4 t = texture(noise_volume, p / kNoisePeriod) * 2.0 - 1.0;
    return vec4(t.xyz * 2.0, t.w);
}

// The same where the pipeline knows no neighbours: `footprint` is the width of a pixel in lattice cells.
vec4 noiseOver(vec3 p, float footprint) {
    vec4 t = textureLod(noise_volume, p / kNoisePeriod, log2(max(footprint * kTexelsPerCell, 1e-6))) * 2.0 - 1.0;
    return vec4(t.xyz * 2.0, t.w);
}

// `p` in m, `per_metre` lattice cells. A pass that computes says how wide a pixel is on the surface; in one that draws the
// pipeline knows.
#if defined(COMPUTED) || defined(FOUND_FACES)
float noise_footprint;  // m
vec4 noise(vec3 p, float per_metre) { return noiseOver(p * per_metre, noise_footprint * per_metre); }
#else
vec4 noise(vec3 p, float per_metre) { return noise(p * per_metre); }
#endif

// Turns so that the octaves' lattices do not line up.
const mat3 kTurn1 = mat3(0.36, 0.48, -0.80, -0.80, 0.60, 0.00, 0.48, 0.64, 0.60);
const mat3 kTurn2 = mat3(0.60, 0.00, 0.80, 0.48, 0.80, -0.36, -0.64, 0.60, 0.48);

// Three octaves; gradients keep their weight from octave to octave, values halve.
vec4 fractureNoise(vec3 p, float per_metre) {
    vec4 a = noise(p, per_metre);
    vec4 b = noise(kTurn1 * p, 2.03 * per_metre);
    vec4 c = noise(kTurn2 * p, 4.11 * per_metre);
    vec3 gradient = a.xyz + 0.8 * (transpose(kTurn1) * b.xyz) + 0.6 * (transpose(kTurn2) * c.xyz);
    return vec4(0.45 * gradient, (a.w + 0.5 * b.w + 0.25 * c.w) / 1.75);
}
