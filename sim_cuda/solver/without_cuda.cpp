// SPDX-License-Identifier: Apache-2.0
// What the CUDA entry points say in a build without the toolkit.
#if !defined(DEMOLISH_WITH_CUDA)
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

std::unique_ptr<Solver> makeCudaSolver(const SceneSetup&, const ProgressCallback&) {
    throw DeviceError(
        "This program was built without CUDA; install the CUDA toolkit and build again, or use --device "
        "cpu.");
}

CudaDevice findCudaDevice() {
    CudaDevice device;
    device.problem = "built without CUDA";
    return device;
}

}  // namespace demolish
#endif
