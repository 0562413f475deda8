// SPDX-License-Identifier: Apache-2.0
// The CPU solver in double precision: a measuring stick for tests, not for users.
#pragma once
#include "sim_cuda/api/solver.h"

namespace demolish {

std::unique_ptr<Solver> makeCpuSolverDouble(const SceneSetup& setup, const ProgressCallback& progress = {});

}  // namespace demolish
