// SPDX-License-Identifier: Apache-2.0
// The dark inside of a crack. Across it one looks at the wall beyond, the deeper the farther from that wall: its rim gets half
// of the light, and what lies deep between two walls next to none.
#include "common/crack_colour.glsl"
layout(location = 5) uniform vec2 noise_shape;  // of the broken material: wavelength m, strength 0..1
const float kDark = 0.97;      // share of the material that it hides where it is deep
const float kSteeper = 3.0;    // walls are rough: they shade each other as if they stood closer
const float kWallsFrom = 0.7;  // px of half a width, from which on one sees walls: a hairline is a dark line

// Share of the colour's root that is hidden, at a depth in widths of the crack: what a wall sees of the opening over it.
float hiddenAt(float depth) {
    float d = kSteeper * depth;
    return 1.0 - sqrt(0.5 - 0.5 * d * inversesqrt(1.0 + d * d));
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

// `slant`: tangent of the angle by which the eye looks in from the left; `ragged`: -1..1, the broken material's noise there.
float crackCover(CrackPlace place, float half_width, float strength, float slant, float ragged) {
    float walls = smoothstep(kWallsFrom, 4.0 * kWallsFrom, half_width), wide = half_width * (1.0 + walls * noise_shape.y * ragged);
    float from_wall = clamp(0.5 + 0.5 * sign(slant) * place.across / max(wide, 0.5), 0.0, 1.0);
    float deep = mix(1.0, hiddenAt(from_wall / max(abs(slant), 0.02)), walls);
    float hidden = kDark * strength * deep * clamp(wide + 0.5 - abs(place.across), 0.0, 1.0);
    return 1.0 - pow(1.0 - hidden, shareOf(place, half_width));
}
