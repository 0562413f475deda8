// SPDX-License-Identifier: Apache-2.0
// One shot from making to its last frame, watched in one way.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tests/fuzz/shots/random_shot.h"

namespace demolish::fuzz {

struct ShotRun {
    std::string refused;              ///< why it was not made, as the program says it
    std::string stopped;              ///< what the last step said, "" while all went well
    std::vector<std::string> faults;  ///< of the body, and of the frames that were exported
    std::vector<uint64_t> hashes;     ///< of the state, at a few moments that are the same in every run
    uint64_t frames = 0;              ///< simulated
    uint32_t particles = 0, broken = 0;
    double built_seconds = 0, seconds = 0;  ///< wall time of making, and of all
    double brought_in = 0, closure = 1;     ///< J, and 1 where the books close; with the ledger only
    double weight_energy = 0;               ///< J, all bodies' weight times the height of one
};

/// Throws what is no error of the program's own (sim_cuda/api/errors.h): a finding.
ShotRun runShot(const RandomShot& random, const Watching& watching);

}  // namespace demolish::fuzz
