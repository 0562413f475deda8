// SPDX-License-Identifier: Apache-2.0
#include "app/bridge/cuda_frame_memory.h"

#include "app/bridge/cuda_check.h"
#include "app/bridge/cuda_stream.h"

namespace demolish {

CudaFrameMemory::CudaFrameMemory(const Solver& solver) : stream_(streamOf(solver)) {}

CudaFrameMemory::~CudaFrameMemory() {
    for (void* block : blocks_) cudaFree(block);
}

void* CudaFrameMemory::reserve(size_t bytes) {
    blocks_.push_back(nullptr);
    checkCuda(cudaMalloc(&blocks_.back(), bytes), "allocating memory for a frame");
    return blocks_.back();
}

void CudaFrameMemory::read(void* to, const void* from, size_t bytes) {
    copyToHost(to, from, bytes, stream_, "copying a frame");
}

}  // namespace demolish
