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
    /// That of the lane whose number differs in bit `bit`.
    template <class T>
    __device__ __forceinline__ T across(uint32_t bit, T value) const {
        return __shfl_xor_sync(mask(), value, static_cast<int>(bit), kLanes);
    }

  private:
    static __device__ __forceinline__ uint32_t mask() {
        return (0xffffffffu >> (32 - kLanes)) << (threadIdx.x % 32 & ~(kLanes - 1));
    }
#else
    template <class T>
    T across(uint32_t, T value) const {
        return value;
    }
#endif
};

}  // namespace demolish
