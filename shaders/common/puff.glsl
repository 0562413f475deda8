// SPDX-License-Identifier: Apache-2.0
// One puff of dust or smoke (32 bytes).
struct Puff {
    vec4 position_radius;  // m; radius 0: there is none
    float depth;           // optical depth through its middle
    float age;             // s
    uint seed;
    float heat;            // 0: dust, 1: smoke
};
layout(std430, binding = 14) readonly buffer Puffs { Puff puffs[]; };

// Corner of the square about it, -1..1: a strip of four.
vec2 squareCorner(int vertex) { return vec2(2 * (vertex >> 1) - 1, 2 * (vertex & 1) - 1); }
