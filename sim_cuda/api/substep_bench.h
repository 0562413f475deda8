// SPDX-License-Identifier: Apache-2.0
// For benchmarks of the substep: a block of stone of any size, and what a substep on it costs at the least.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim_cuda/api/breakable_body.h"

namespace demolish {

/// A cube of 1 m edge, standing on y = 0, of about `particles` (at least 8) cubic cells, as many along each
/// edge; seeds moved by up to a tenth of the spacing. Inside, a particle has 12 bonds: to its six neighbours
/// and across six of its twelve edges. Without draw geometry. Throws UsageError when `particles` is out of
/// range.
std::shared_ptr<const BreakableBody> stoneBlock(uint32_t particles);

/// One way to launch the floor's substep, and what it took.
struct FloorScheme {
    std::string name;  ///< "graph, 4 threads a particle"
    double microseconds = 0;
};

/// What no substep on this body and machine can go below.
struct SubstepFloor {
    double bytes = 0;           ///< that a substep must move: states in and out, bonds in
    double copy_bandwidth = 0;  ///< bytes/s of a large copy, read and written bytes together
    double memory_us = 0;       ///< bytes / copy_bandwidth
    double bonds_us = 0;        ///< bonds and integration alone, the best of `schemes`; 0: not measured
    std::vector<FloorScheme> schemes;
};

/// Measured now, in about a second, on the GPU that solvers use. Throws DeviceError without one.
SubstepFloor cudaSubstepFloor(const BreakableBody& body);
/// The memory's part only, by copies on all threads.
SubstepFloor cpuSubstepFloor(const BreakableBody& body);

}  // namespace demolish
