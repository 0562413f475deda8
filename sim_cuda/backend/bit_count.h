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

}  // namespace demolish
