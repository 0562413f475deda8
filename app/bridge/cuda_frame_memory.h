// SPDX-License-Identifier: Apache-2.0
// Device memory that a GPU solver writes a frame into; copies go over the solver's stream.
#pragma once
#include <vector>

#include "app/bridge/frame_memory.h"
#include "sim_cuda/api/solver.h"

struct CUstream_st;

namespace demolish {

class CudaFrameMemory : public FrameMemory {
  public:
    explicit CudaFrameMemory(const Solver& solver);
    ~CudaFrameMemory() override;
    CudaFrameMemory(const CudaFrameMemory&) = delete;
    CudaFrameMemory& operator=(const CudaFrameMemory&) = delete;

    /// Throws DeviceError, also when the GPU's memory does not suffice.
    void* reserve(size_t bytes) override;
    void read(void* to, const void* from, size_t bytes) override;

  private:
    CUstream_st* stream_;  ///< cudaStream_t
    std::vector<void*> blocks_;
};

}  // namespace demolish
