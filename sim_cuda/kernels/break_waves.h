// SPDX-License-Identifier: Apache-2.0
// Waves of a break, several cells long: without them large faces are as even as if they were sawn.
#pragma once
#include "sim_cuda/physics/value_noise.h"

namespace demolish {

/// Over h: the length of the longest.
inline constexpr float kBreakWave = 2.5f;
/// Of waves half as long: breaks are rough on all scales, with a height that goes by length to 0.8 (Bouchaud
/// 1997, self-affine fracture surfaces).
inline constexpr float kShorterWaves = 0.57f;
inline constexpr uint32_t kBreakWaveSalt = 11;

/// m, by the place at rest and so the same on both sides; `height`: m, each component is within 1.57 of it.
DEM_FN Vec3<float> breakWaves(const Vec3<float>& rest, float spacing, float height) {
    if (height <= 0) return {};
    const Vec3<float> shift{7.31f, 15.77f, 3.93f}, p = (1.0f / (kBreakWave * spacing)) * rest + shift;
    const Vec3<float> shorter = valueNoise(2.03f * p, kBreakWaveSalt + 1);
    return height * axpy(kShorterWaves, shorter, valueNoise(p, kBreakWaveSalt));
}

}  // namespace demolish
