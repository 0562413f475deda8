// SPDX-License-Identifier: Apache-2.0
// Coarser levels of a texture from a tile of 8 x 8 of its texels, as the work group has them: one pass in place of one a level.
shared vec4 level_texels[64];

// `own`: of the level before, of the first 4 * side * side lanes. The first side * side get the mean of four; all call it.
vec4 halved(vec4 own, uint side) {
    uint lane = gl_LocalInvocationIndex, row = 2u * side;
    barrier();
    if (lane < row * row) level_texels[lane] = own;
    barrier();
    if (lane >= side * side) return own;
    uint first = 2u * (lane / side) * row + 2u * (lane % side);
    return 0.25 * ((level_texels[first] + level_texels[first + 1u]) + (level_texels[first + row] + level_texels[first + row + 1u]));
}

bool isInLevel(uint side) { return gl_LocalInvocationIndex < side * side; }
ivec2 placeInLevel(uint side) {
    uint lane = gl_LocalInvocationIndex;
    return ivec2(side * gl_WorkGroupID.xy + uvec2(lane % side, lane / side));
}
