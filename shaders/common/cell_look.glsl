// SPDX-License-Identifier: Apache-2.0
// Bodies of several looks are drawn look by look: cells of the others are put outside the picture.
layout(std430, binding = 7) readonly buffer CellLooks { uint cell_look[]; };
layout(location = 30) uniform uint hidden_looks;  // a bit a look

vec4 unlessHidden(vec4 position, uint cell) {
    bool hidden = hidden_looks != 0u && (hidden_looks >> cell_look[cell] & 1u) != 0u;
    return hidden ? vec4(2.0, 2.0, 2.0, 1.0) : position;
}
