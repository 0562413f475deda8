// The solver on the CPU.
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

std::unique_ptr<Solver> makeCpuSolver(const SceneSetup& setup, const ProgressCallback& progress) {
    return std::make_unique<DeviceSolver<CpuBackend, float>>(setup, progress);
}

}  // namespace demolish
