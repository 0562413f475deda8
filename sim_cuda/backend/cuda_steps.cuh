// SPDX-License-Identifier: Apache-2.0
// Steps of an iteration in one launch: its blocks all run at once and wait for one another between steps, and
// steps that would do nothing are left out.
#pragma once
#include <cooperative_groups.h>
#include <cuda_runtime.h>

#include <algorithm>
#include <cstdint>

#include "sim_cuda/backend/cuda_error.h"
#include "sim_cuda/backend/span.h"

namespace demolish {

inline constexpr uint32_t kStepsBlock = 512;

/// kernel(ids[k], step) for all k below count[0] at the same time, for one step after the other, until
/// kernel.isOver(step), which is the same for all threads.
template <class Kernel>
__global__ void __launch_bounds__(kStepsBlock)
    runSteps(Span<const uint32_t> ids, Span<const uint32_t> count, uint32_t steps, Kernel kernel) {
    const auto grid = cooperative_groups::this_grid();
    const uint32_t threads = gridDim.x * kStepsBlock, thread = blockIdx.x * kStepsBlock + threadIdx.x;
    const uint32_t n = count[0];
    for (uint32_t step = 0; step < steps && !kernel.isOver(step); ++step) {
        for (uint32_t k = thread; k < n; k += threads) kernel(ids[k], step);
        grid.sync();
    }
}

/// Starts that; `ids` has room for as many as may be listed. Throws on failure.
template <class Kernel>
void launchSteps(cudaStream_t stream, int multiprocessors, Span<const uint32_t> ids,
                 Span<const uint32_t> count, uint32_t steps, const Kernel& kernel, const char* name) {
    const auto needed = static_cast<uint32_t>((ids.count + kStepsBlock - 1) / kStepsBlock);
    cudaLaunchAttribute together{};
    together.id = cudaLaunchAttributeCooperative;
    together.val.cooperative = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = std::min(needed, static_cast<uint32_t>(multiprocessors));
    config.blockDim = kStepsBlock;
    config.stream = stream;
    config.attrs = &together;
    config.numAttrs = 1;
    checkCuda(cudaLaunchKernelEx(&config, runSteps<Kernel>, ids, count, steps, kernel), name);
}

}  // namespace demolish
