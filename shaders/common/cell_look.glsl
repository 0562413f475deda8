// SPDX-License-Identifier: Apache-2.0
// Bodies of several looks are drawn look by look: cells of the others are put outside the picture.
// Of each cell its look in the low half, and how pale its body is beside others of its kind, a snorm, in the high one.
#ifndef CELL_LOOKS
#define CELL_LOOKS 7
#endif
layout(std430, binding = CELL_LOOKS) readonly buffer CellLooks { uint cell_look[]; };
layout(location = 30) uniform uint hidden_looks;  // a bit a look

bool isHidden(uint cell) { return hidden_looks != 0u && (hidden_looks >> (cell_look[cell] & 0xffffu) & 1u) != 0u; }

vec4 unlessHidden(vec4 position, uint cell) { return isHidden(cell) ? vec4(2.0, 2.0, 2.0, 1.0) : position; }

// Factor of its body's colours; a `variation` of 0 reads nothing.
float paleness(float variation, uint cell) { return variation > 0.0 ? 1.0 + variation * unpackSnorm2x16(cell_look[cell]).y : 1.0; }

// Where in its solid texture a body was cut from, m from where others of its kind were, or they would look printed.
vec3 cutFrom(float variation, uint cell) {
    if (!(variation > 0.0)) return vec3(0.0);
    return 4.0 * fract(43.758 * sin(vec3(12.9898, 78.233, 37.719) * unpackSnorm2x16(cell_look[cell]).y));
}
