// SPDX-License-Identifier: Apache-2.0
// The inside of a crack. Across it one looks at the wall beyond, which is of the broken material, the deeper the farther from
// that wall: its rim gets half of the light, and what lies deep between two walls next to none.
#include "common/crack_colour.glsl"
layout(location = 5) uniform vec2 noise_shape;  // of the broken material: wavelength m, strength 0..1
const float kDark = 0.97;      // share of the outside that a line hides
const float kSteeper = 3.0;    // walls are rough: they shade each other as if they stood closer
const float kChipped = 0.5;    // of what is ragged lies so much within the line's own width: edges are chipped
const float kChipLight = 0.85; // root of the light on a chip
const float kWallsFrom = 0.7;  // px of half a width, from which on one sees walls: a hairline is a dark line

// Root of the light on the wall at a depth in widths of the crack: what it sees of the opening over it.
float wallLight(float depth) {
    float d = kSteeper * depth;
    return sqrt(0.5 - 0.5 * d * inversesqrt(1.0 + d * d));
}

// A place on a line, px.
struct CrackPlace {
    float across;         // from the middle, to the left of the line
    float start, finish;  // inside of its ends; negative beyond them
};

// Lines that follow each other overlap by this at their ends, in half widths; what each hides there adds up to the whole.
const float kOverlap = 0.5;

float shareOf(CrackPlace place, float half_width) {
    vec2 inside = clamp(0.5 + 0.5 * vec2(place.start, place.finish) / (kOverlap * half_width), 0.0, 1.0);
    return max(inside.x + inside.y - 1.0, 0.0);
}

// `slant`: tangent of the angle by which the eye looks in from the left; `ragged`: as raggedAt() has it.
CrackCover crackCover(CrackPlace place, float half_width, float strength, float slant, vec2 ragged) {
    float walls = smoothstep(kWallsFrom, 4.0 * kWallsFrom, half_width), rough = walls * noise_shape.y;
    float away = abs(place.across), wide = half_width * (1.0 + rough * (place.across > 0.0 ? ragged.x : ragged.y));
    float core = half_width * (1.0 - kChipped * rough);
    float from_wall = clamp(0.5 + 0.5 * sign(slant) * place.across / max(core, 0.5), 0.0, 1.0);
    float light = mix(wallLight(from_wall / max(abs(slant), 0.02)), kChipLight, clamp(away - core + 0.5, 0.0, 1.0));
    float hidden = kDark * strength * clamp(wide + 0.5 - away, 0.0, 1.0);
    float hides = 1.0 - pow(1.0 - hidden, shareOf(place, half_width));
    return CrackCover(hides, hides * walls * light);
}
