// SPDX-License-Identifier: Apache-2.0
// Threads of a warp that do the same for one thing and share what of it is long. A CPU has one.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/function.h"

namespace demolish {

/// kLanes: a power of 2, at most 32; groups begin at multiples of it in the warp. All of a group call each of
/// these together.
template <uint32_t kLanes>
struct LaneGroup {
    static constexpr uint32_t kCount = kLanes;
    uint32_t lane = 0;  ///< below kLanes

    /// What must be done once is for this one.
    DEM_FN bool leads() const { return kLanes == 1 || lane == 0; }

#if defined(__CUDA_ARCH__)
    /// That of lane `other`.
    template <class T>
    __device__ __forceinline__ T from(uint32_t other, T value) const {
        if constexpr (kLanes > 1) return __shfl_sync(mask(), value, static_cast<int>(other), kLanes);
        return value;
    }
    /// Bits that are set in any.
    __device__ __forceinline__ uint32_t united(uint32_t bits) const {
        for (uint32_t step = kLanes / 2; step > 0; step /= 2)
            bits |= __shfl_xor_sync(mask(), bits, static_cast<int>(step), kLanes);
        return bits;
    }
    template <class T>
    __device__ __forceinline__ T least(T value) const {
        for (uint32_t step = kLanes / 2; step > 0; step /= 2) {
            const T other = __shfl_xor_sync(mask(), value, static_cast<int>(step), kLanes);
            value = other < value ? other : value;
        }
        return value;
    }

  private:
    static __device__ __forceinline__ uint32_t mask() {
        return (0xffffffffu >> (32 - kLanes)) << (threadIdx.x % 32 & ~(kLanes - 1));
    }
#else
    template <class T>
    T from(uint32_t, T value) const {
        return value;
    }
    uint32_t united(uint32_t bits) const {
        return bits;
    }
    template <class T>
    T least(T value) const {
        return value;
    }
#endif
};

}  // namespace demolish
