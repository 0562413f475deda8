// SPDX-License-Identifier: Apache-2.0
// Grows to twice what is asked for, so that it seldom does: such memory takes longer to get than to fill.
#include "app/bridge/cuda_pinned_memory.h"

#include "app/bridge/cuda_check.h"

namespace demolish {

PinnedMemory::~PinnedMemory() {
    cudaFreeHost(data_);
}

void* PinnedMemory::atLeast(size_t bytes) {
    if (bytes <= bytes_) return data_;
    checkCuda(cudaFreeHost(data_), "freeing pinned memory");
    data_ = nullptr;
    bytes_ = 0;
    checkCuda(cudaMallocHost(&data_, 2 * bytes), "allocating pinned memory");
    bytes_ = 2 * bytes;
    return data_;
}

}  // namespace demolish
