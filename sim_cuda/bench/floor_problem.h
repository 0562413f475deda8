// SPDX-License-Identifier: Apache-2.0
// The arrays of the floor's substep for a body, on the host, and the substep itself as a reference.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/bench/floor_law.h"

namespace demolish {

inline constexpr uint32_t kNoOther = 0xffffffffu;

/// Bonds stored from both ends, rows by particle.
struct FloorProblem {
    std::vector<FloorState> states;
    std::vector<uint32_t> row;    ///< CSR, size particles + 1
    std::vector<uint32_t> other;  ///< of each slot
    std::vector<FloorRest> rest;  ///< of each slot
    FloorConstants constants;
};

/// At rest but for velocities and spins of a thousandth, from a counter. Nothing breaks: limits are half a
/// spacing.
FloorProblem makeFloorProblem(const BreakableBody& body);

/// `substeps` of the law on the host.
void stepOnHost(FloorProblem& problem, uint32_t substeps);

/// Bytes that a substep must move: each state read and written once, other end and rest of each slot, the
/// rows.
double bytesOfSubstep(const FloorProblem& problem);
/// The same from a body's counts.
double bytesOfSubstep(size_t particles, size_t bonds);

}  // namespace demolish
