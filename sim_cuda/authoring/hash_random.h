// SPDX-License-Identifier: Apache-2.0
// Random numbers of the authoring: a stream for each purpose, a value for each counter, whatever the order of
// calls.
#pragma once
#include "sim_cuda/api/vectors.h"
#include "sim_cuda/physics/random.h"

namespace demolish {

/// Uniform in (0, 1).
inline double hashRandom(uint64_t seed, uint64_t stream, uint64_t counter) {
    return uniformOf(counterHash(seed, stream), counter);
}

/// Uniform in (-1/2, 1/2)^3.
inline Double3 hashRandomInCube(uint64_t seed, uint64_t stream, uint64_t counter) {
    const uint64_t key = counterHash(seed, stream);
    return {uniformOf(key, 3 * counter) - 0.5, uniformOf(key, 3 * counter + 1) - 0.5,
            uniformOf(key, 3 * counter + 2) - 0.5};
}

}  // namespace demolish
