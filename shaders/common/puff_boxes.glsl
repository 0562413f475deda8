// SPDX-License-Identifier: Apache-2.0
// Puffs on their way into the sums: how each is seen, the box that it takes, and which of them reach each square of the sums.
// Accesses are PUFFS_ACCESS (of the first two) and LISTS_ACCESS.
#include "common/effect_commands.glsl"
const uint kNoBox = 0xffffffffu;
layout(location = 2) uniform ivec4 squares;  // px: width and height of the sums, side of a square; squares in a row
layout(std430, binding = 19) PUFFS_ACCESS buffer SeenPuffs { SeenPuff seen_puffs[]; };
layout(std430, binding = 20) PUFFS_ACCESS buffer PuffBoxes { uvec2 puff_boxes[]; };  // low x and y, high x and y: 16 bits each
layout(std430, binding = 21) LISTS_ACCESS buffer PuffLists { uint puff_lists[]; };   // of a square: how many, then which

// Where the list of a square begins.
uint listAt(uint square) { return square * (uint(seen_puffs.length()) + 1u); }

// Whether a box reaches the pixels from `first` on, `side` either way.
bool reaches(uvec2 box, uvec2 first, uint side) {
    uvec2 low = uvec2(box.x & 0xffffu, box.x >> 16), high = uvec2(box.y & 0xffffu, box.y >> 16);
    return all(lessThan(low, first + side)) && all(greaterThanEqual(high, first));
}
