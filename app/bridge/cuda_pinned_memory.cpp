// Grows by half, so that it seldom does.
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
    checkCuda(cudaMallocHost(&data_, bytes + bytes / 2), "allocating pinned memory");
    bytes_ = bytes + bytes / 2;
    return data_;
}

}  // namespace demolish
