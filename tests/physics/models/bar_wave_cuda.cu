// SPDX-License-Identifier: Apache-2.0
// The bar on the GPU.
#include "sim_cuda/backend/cuda_backend.cuh"
#include "sim_cuda/solver/cuda_pair_finder.cuh"
#include "sim_cuda/solver/cuda_rigid_runner.cuh"
#include "sim_cuda/solver/cuda_substep_runner.cuh"
#include "tests/physics/models/bar_ring.h"

namespace demolish::tests {

BarWave ringBarOnGpu(const SceneSetup& setup, const SceneTables& tables, const Vec3<double>& axis,
                     double length) {
    return ringBarOn<CudaBackend, float>(setup, tables, axis, length);
}

}  // namespace demolish::tests
