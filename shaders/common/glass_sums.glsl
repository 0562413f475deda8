// SPDX-License-Identifier: Apache-2.0
// What transparent bodies take from the sun's light in each texel of its view, in whole steps, so that the order of adding does
// not count: how far it goes inside of them, minus the logarithm of what their faces leave, and the ends of the way
// (glass_ends.glsl), one step more; 0: there is none.
layout(std430, binding = 7) buffer Sums { ivec4 sums[]; };

const int kSumTexels = 1024;  // along the view
const float kStepsOfRadius = 1048576.0, kStepsOfLost = 65536.0, kStepsOfEnds = 268435456.0;
