// SPDX-License-Identifier: Apache-2.0
// The solver's stream, on which every bridge maps and copies. The legacy stream is not used: CUDA forbids it
// while another thread records a graph, as the solver of a rebuild does beside the one that is drawn.
#pragma once
#include <cuda_runtime_api.h>

#include "app/bridge/cuda_check.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

inline cudaStream_t streamOf(const Solver& solver) {
    return static_cast<cudaStream_t>(solver.workStream());
}

/// After what was started on the stream before; waits. `what`: for messages. Throws DeviceError.
inline void copyToHost(void* to, const void* from, size_t bytes, cudaStream_t stream, const char* what) {
    checkCuda(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, stream), what);
    checkCuda(cudaStreamSynchronize(stream), what);
}

}  // namespace demolish
