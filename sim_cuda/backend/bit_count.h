// SPDX-License-Identifier: Apache-2.0
// Counting bits with one spelling on both devices.
#pragma once
#include <bit>
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

DEM_FN uint32_t countBits(uint32_t word) {
#if defined(__CUDA_ARCH__)
    return static_cast<uint32_t>(__popc(word));
#else
    return static_cast<uint32_t>(std::popcount(word));
#endif
}

/// Of a word that is not 0: the place of its lowest bit that is set.
DEM_FN uint32_t lowestBit(uint32_t word) {
#if defined(__CUDA_ARCH__)
    return static_cast<uint32_t>(__ffs(static_cast<int>(word))) - 1;
#else
    return static_cast<uint32_t>(std::countr_zero(word));
#endif
}

/// The lowest `count` bits, at most 32.
DEM_FN uint32_t lowBits(uint32_t count) {
    return count < 32 ? (1u << count) - 1 : 0xffffffffu;
}

}  // namespace demolish
