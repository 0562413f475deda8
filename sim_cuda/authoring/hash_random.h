// Random numbers as a pure function of (seed, stream, counter): the same on every machine and for any thread
// count.
#pragma once
#include <cstdint>

#include "sim_cuda/api/vectors.h"

namespace demolish {

/// Mixes all 64 bits (the finaliser of SplitMix64, Steele et al. 2014).
inline uint64_t mixedBits(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Uniform in [0, 1).
inline double hashRandom(uint64_t seed, uint64_t stream, uint64_t counter) {
    constexpr uint64_t kGolden = 0x9e3779b97f4a7c15ull;
    const uint64_t bits =
        mixedBits(mixedBits(mixedBits(seed + kGolden) + stream * kGolden) + counter * kGolden);
    return double(bits >> 11) * 0x1p-53;
}

/// Uniform in [-1/2, 1/2)^3.
inline Double3 hashRandomInCube(uint64_t seed, uint64_t stream, uint64_t counter) {
    return {hashRandom(seed, stream, 3 * counter) - 0.5, hashRandom(seed, stream, 3 * counter + 1) - 0.5,
            hashRandom(seed, stream, 3 * counter + 2) - 0.5};
}

}  // namespace demolish
