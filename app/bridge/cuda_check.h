// SPDX-License-Identifier: Apache-2.0
// A CUDA call that fails becomes one sentence.
#pragma once
#include <cuda_runtime_api.h>

#include <string>

#include "sim_cuda/api/errors.h"

namespace demolish {

inline void checkCuda(cudaError_t error, const char* what) {
    if (error != cudaSuccess)
        throw DeviceError(std::string(what) + " failed: " + cudaGetErrorString(error) +
                          "; --device cpu works without the GPU");
}

}  // namespace demolish
