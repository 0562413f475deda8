// SPDX-License-Identifier: Apache-2.0
// A set-up with hand-over and sleep as a test wants them.
#pragma once
#include "sim_cuda/api/params.h"

namespace demolish::tests {

struct Regimes {
    bool hand_over, sleeping;
};

inline SceneSetup with(SceneSetup setup, Regimes regimes) {
    setup.params.hand_over = regimes.hand_over;
    setup.params.sleeping = regimes.sleeping;
    return setup;
}

}  // namespace demolish::tests
