// SPDX-License-Identifier: Apache-2.0
// Sums of the dust's shadow: optical depth, and below it optical depth times depth in the region.
layout(r32ui, binding = 0) uniform uimage2D sums;
const int kTexels = 256;      // along, as engine/passes/dust_shadow_pass.cpp
const float kSteps = 4096.0;  // of an optical depth: 200,000 puffs of depth 5 have room in one texel

ivec2 depthAt(ivec2 texel) { return texel; }
ivec2 placeAt(ivec2 texel) { return texel + ivec2(0, kTexels); }
