// SPDX-License-Identifier: Apache-2.0
const vec3 kCrackColour = vec3(0.09, 0.085, 0.08);  // of the dark inside of a crack, square root of the albedo

// What a line hides of the material behind it, and the part of that which shows a wall's own colour in place of the dark.
struct CrackCover {
    float hides, wall;  // 0 <= wall <= hides <= 1
};

// Square root of the albedo of what a line shows, over what it hides; `wall`: that of the broken material.
vec3 crackRoot(CrackCover cover, vec3 wall) { return mix(kCrackColour, wall, cover.wall / max(cover.hides, 1e-4)); }
