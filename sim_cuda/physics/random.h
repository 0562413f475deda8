// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers: the value depends on (seed, index) alone, so no order of evaluation can
// change it.
#pragma once
#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// 64 well-mixed bits of a counter (the finaliser of splitmix64 applied to seed and index in turn).
DEM_FN uint64_t counterHash(uint64_t seed, uint64_t index) {
    uint64_t z = seed + 0x9e3779b97f4a7c15ull * (index + 1);
    for (int round = 0; round < 2; ++round) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        z ^= z >> 31;
    }
    return z;
}

/// Uniform in (0, 1), never 0 and never 1; 53 bits.
DEM_FN double uniformOf(uint64_t seed, uint64_t index) {
    return (static_cast<double>(counterHash(seed, index) >> 12) + 0.5) * (1.0 / 4503599627370496.0);
}

}  // namespace demolish
