// SPDX-License-Identifier: Apache-2.0
// The solver on the CPU.
#include "sim_cuda/solver/cpu_substep_runner.h"
#include "sim_cuda/solver/device_solver.h"
#include "sim_cuda/solver/double_solver.h"

namespace demolish {

std::unique_ptr<Solver> makeCpuSolver(const SceneSetup& setup, const ProgressCallback& progress) {
    return std::make_unique<DeviceSolver<CpuBackend, float>>(setup, progress);
}

std::unique_ptr<Solver> makeCpuSolverDouble(const SceneSetup& setup, const ProgressCallback& progress) {
    return std::make_unique<DeviceSolver<CpuBackend, double>>(setup, progress);
}

}  // namespace demolish
