// SPDX-License-Identifier: Apache-2.0
// Turns CUDA's error codes into the program's own exception.
#pragma once
#include <cuda_runtime_api.h>

#include <string>

#include "sim_cuda/api/errors.h"

namespace demolish {

/// Throws DeviceError naming what was attempted.
inline void checkCuda(cudaError_t code, const char* what) {
    if (code == cudaSuccess) return;
    throw DeviceError(std::string("CUDA failed while ") + what + ": " + cudaGetErrorString(code) +
                      "; try --device cpu");
}

}  // namespace demolish
