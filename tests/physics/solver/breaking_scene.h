// SPDX-License-Identifier: Apache-2.0
// The scene that every device and thread count has to run alike: a brick that an iron ball and the floor
// break.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

/// 640 particles dropped at a slant, with a ball that arrives during the run, friction, rolling, Weibull
/// scatter, cells.
SceneSetup breakingScene();

inline constexpr std::array<uint32_t, 6> kHashedSubsteps{1, 10, 100, 500, 1000, 2000};

/// State hashes after kHashedSubsteps.
std::vector<uint64_t> hashesOf(Solver& solver);

}  // namespace demolish::tests
