// SPDX-License-Identifier: Apache-2.0
// Light of the sun on the floor that transparent bodies have bent, in whole steps of what falls on a texel of its view: the order
// of adding does not count. w: corners of the texel, of four, whose rays meet such a body. What is drawn out far is in a coarser grid behind it.
layout(std430, binding = 7) buffer Caustics { ivec4 caustics[]; };

const int kCausticTexels = 512;  // along the near region of the sun's map
const int kCoarseTexels = 64;    // likewise
const int kCoarse = kCausticTexels * kCausticTexels;
const float kStepsOfLight = 65536.0;
