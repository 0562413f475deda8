// SPDX-License-Identifier: Apache-2.0
// Steps of an iteration in one launch: as many of its blocks as the list needs run at once and wait for one
// another between steps, and steps that would do nothing are left out.
#pragma once
#include <cuda_runtime.h>

#include <algorithm>
#include <cstdint>
#include <cuda/atomic>

#include "sim_cuda/backend/cuda_error.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

inline constexpr uint32_t kStepsBlock = 512;

/// Where the first blocks of a launch wait for one another; the next launch on the same stream may go on with
/// it. The grid's own barrier waits for all blocks, also those without work.
struct StepsBarrier {
    uint32_t* arrived;  ///< 0 before
    uint32_t* turn;     ///< any number

    /// What the threads of `blocks` blocks have written before is seen by all of them after.
    __device__ void wait(uint32_t blocks) const {
        __syncthreads();
        if (blocks == 1) return;
        if (threadIdx.x == 0) {
            using Word = cuda::atomic_ref<uint32_t, cuda::thread_scope_device>;
            const uint32_t before = Word(*turn).load(cuda::memory_order_relaxed);
            if (Word(*arrived).fetch_add(1, cuda::memory_order_acq_rel) == blocks - 1) {
                Word(*arrived).store(0, cuda::memory_order_relaxed);
                Word(*turn).store(before + 1, cuda::memory_order_release);
            } else {
                while (Word(*turn).load(cuda::memory_order_acquire) == before) {
                }
            }
        }
        __syncthreads();
    }
};

/// kernel(ids[k], step) for all k below count[0] at the same time, for one step after the other, until
/// kernel.isOver(step), which is the same for all threads.
template <class Kernel>
__global__ void __launch_bounds__(kStepsBlock) runSteps(Span<const uint32_t> ids, Span<const uint32_t> count,
                                                        uint32_t steps, Kernel kernel, StepsBarrier barrier) {
    const uint32_t n = count[0], needed = (n + kStepsBlock - 1) / kStepsBlock;
    const uint32_t blocks = needed < gridDim.x ? needed : gridDim.x;
    if (blockIdx.x >= blocks) return;
    const uint32_t threads = blocks * kStepsBlock, thread = blockIdx.x * kStepsBlock + threadIdx.x;
    for (uint32_t step = 0; step < steps && !kernel.isOver(step); ++step) {
        for (uint32_t k = thread; k < n; k += threads) kernel(ids[k], step);
        barrier.wait(blocks);
    }
}

/// Starts that; `ids` has room for as many as may be listed. Throws on failure.
template <class Kernel>
void launchSteps(cudaStream_t stream, int multiprocessors, Span<const uint32_t> ids,
                 Span<const uint32_t> count, uint32_t steps, const Kernel& kernel,
                 const StepsBarrier& barrier, const char* name) {
    const auto needed = static_cast<uint32_t>((ids.count + kStepsBlock - 1) / kStepsBlock);
    cudaLaunchAttribute together{};  // or a block might wait for one that has not begun
    together.id = cudaLaunchAttributeCooperative;
    together.val.cooperative = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = std::min(needed, static_cast<uint32_t>(multiprocessors));
    config.blockDim = kStepsBlock;
    config.stream = stream;
    config.attrs = &together;
    config.numAttrs = 1;
    checkCuda(cudaLaunchKernelEx(&config, runSteps<Kernel>, ids, count, steps, kernel, barrier), name);
}

}  // namespace demolish
