// SPDX-License-Identifier: Apache-2.0
// Which fragment each particle belongs to, brought to the host from wherever the solver keeps it.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish {

/// One slot a particle of the bodies (see RenderStreams). Waits for the solver. Throws DeviceError.
std::vector<uint32_t> readFragments(Solver& solver);

}  // namespace demolish
