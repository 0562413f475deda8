// SPDX-License-Identifier: Apache-2.0
// The particles of a frame, brought to the host from either device.
#pragma once
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

struct ExportedFrame {
    std::vector<ParticleInstance> particles;
    std::vector<uint32_t> fragments;  ///< of each particle
};

/// The first `count` particles (streamSizes(setup).particles: all, with the projectile slots).
ExportedFrame exportedFrame(Solver& solver, size_t count);

}  // namespace demolish::tests
