// SPDX-License-Identifier: Apache-2.0
// Does a scene tell whether hand-over and sleep were on? The same questions for a quick test and a thorough
// one.
#pragma once
#include <string>
#include <vector>

#include "tests/physics/scenes/outcome.h"

namespace demolish::tests {

struct HandOverScene {
    const char* name;
    uint32_t particles;                 ///< of each body
    std::vector<uint32_t> bodies = {};  ///< that stay, with their balls; empty: all
    double seconds = 1;                 ///< s simulated; the balls come from 0.05 s to 0.35 s
    int runs = 3;                       ///< packings
    double settled = 0;                 ///< s; 0: as the scene says
};
std::string nameOf(const HandOverScene& scene);
void PrintTo(const HandOverScene& scene, std::ostream* out);

/// How far the means over all packings may differ with hand-over from those without. Debris is chaotic: of
/// one column 16 % more or 6 % fewer bonds break, as its packing has it. Where twice the standard error of
/// the mean difference is more than the bound, that holds in its place; the error itself may be no more than
/// the bound.
struct HandOverBounds {
    double closure = 0.01, fracture = 0.02, damping_and_friction = 0.05;  ///< over what came in
    /// Of damping alone and of friction alone: what an inner vibration rubs off while it dies is booked as
    /// damping at once by the hand-over.
    double damping_or_friction = 0.06;
    double broken = 0.1;  ///< bonds, relative
    double big = 0.2;     ///< fragments of at least 1 %, relative
    double largest = 0.05, masses = 0.1;
};

/// The scene in some packings, each run without hand-over and sleep and with both. The books of all runs
/// must close.
void expectHandOverUnseen(const HandOverScene& scene, const HandOverBounds& bounds = {});

/// Without gravity and floor, momentum is kept through hits, breaking and hand-over as it is without
/// hand-over.
void expectMomentumKept(const HandOverScene& scene);

}  // namespace demolish::tests
