// SPDX-License-Identifier: Apache-2.0
// What transparent bodies take from the sun's light in each texel of its view, in whole steps, so that the order of adding does
// not count: minus the logarithm of what their faces leave, which none takes away, and how far it goes inside of them.
#ifdef WIDE_ATOMICS
layout(std430, binding = 7) buffer Sums { uint64_t sums[]; };  // the way in the high half
void addSum(uint place, ivec2 steps) { atomicAdd(sums[place], packUint2x32(uvec2(steps))); }
#else
layout(std430, binding = 7) buffer Sums { ivec2 sums[]; };
void addSum(uint place, ivec2 steps) {
    atomicAdd(sums[place].x, steps.x);
    atomicAdd(sums[place].y, steps.y);
}
#endif

const int kSumTexels = 1024;  // along the view
const float kStepsOfRadius = 1048576.0, kStepsOfLost = 65536.0;
