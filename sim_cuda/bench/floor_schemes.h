// SPDX-License-Identifier: Apache-2.0
// The ways in which the floor's substep can be launched, and what each gives; the tests' door to them.
#pragma once
#include <string>
#include <vector>

#include "sim_cuda/bench/floor_problem.h"

namespace demolish {

struct FloorOutcome {
    std::string scheme;
    std::vector<FloorState> states;
};

/// States after `substeps` (even) by every scheme that fits, each from the problem's start. Throws
/// DeviceError without a GPU.
std::vector<FloorOutcome> cudaFloorOutcomes(const FloorProblem& problem, uint32_t substeps);

}  // namespace demolish
