// SPDX-License-Identifier: Apache-2.0
// First longitudinal mode of a free bar: on the CPU in double precision, on the GPU in the solver's single
// one.
#include "tests/physics/models/bar_wave.h"

#include <stdexcept>

#include "sim_cuda/solver/cpu_substep_runner.h"
#include "tests/physics/models/bar_ring.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {

#if !defined(DEMOLISH_WITH_CUDA)
BarWave ringBarOnGpu(const SceneSetup&, const SceneTables&, const Vec3<double>&, double) {
    throw std::logic_error("built without CUDA");  // tests that ask for the GPU are skipped then
}
#endif

BarWave ringBar(const SceneSetup& setup, const SceneTables& tables, const Vec3<double>& axis, double length) {
    return asksForGpu() ? ringBarOnGpu(setup, tables, axis, length)
                        : ringBarOn<CpuBackend, double>(setup, tables, axis, length);
}

}  // namespace demolish::tests
