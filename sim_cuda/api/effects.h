// SPDX-License-Identifier: Apache-2.0
// Grit, dust and sparks: what flies off where bodies break and meet hard. It reads the bodies and never acts
// back on them. Why and how: docs/decisions/effects.md.
#pragma once
#include <cstdint>

namespace demolish {

/// What a material throws off.
struct Debris {
    double grit_per_m2 = 8800;      ///< grains above 1 mm from a m^2 of new face, 0..1e6
    double dust_m2_per_m2 = 0.145;  ///< m^2 of air that the dust of a m^2 of new face dims to 1/e, 0..10
    double sparks = 0;              ///< share of iron's hard hits that give sparks, 0..1

    bool operator==(const Debris&) const = default;
};

inline constexpr uint32_t kMaxGrains = 2'000'000, kMaxPuffs = 200'000, kMaxSparks = 4096;
/// Sizes of grains, in particle spacings h.
inline constexpr double kFinestGrain = 0.03, kCoarsestGrain = 0.4;
/// How many are larger than s goes as s to the power of minus this (looks 1).
inline constexpr double kSizeExponent = 2.2;

struct EffectsSettings {
    bool on = false;
    double grit = 1, dust = 1, sparks = 1;      ///< times what the material says, 0..10
    double finest = kFinestGrain;               ///< h, the smallest grain; 0.01..0.3: larger ones are fewer
    bool crumbling = true;                      ///< single cells are drawn smaller and lose crumbs
    uint32_t grains = 200'000, puffs = 20'000;  ///< at most so many at a time: the oldest make room

    bool operator==(const EffectsSettings&) const = default;
};

}  // namespace demolish
