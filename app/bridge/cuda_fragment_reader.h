// SPDX-License-Identifier: Apache-2.0
// The way of fragment slots from a GPU solver to the host.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish {

std::vector<uint32_t> readFragmentsFromGpu(Solver& solver);

}  // namespace demolish
