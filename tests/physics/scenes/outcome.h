// SPDX-License-Identifier: Apache-2.0
// What became of a scene: its books and its fragments, to be held against another run's.
#pragma once
#include <cstdint>
#include <vector>

#include "app/session/shot.h"

namespace demolish::tests {

struct SceneOutcome {
    double closure = 0;                              ///< EnergyBalance::closure()
    double damping = 0, friction = 0, fracture = 0;  ///< over what came in
    double broken = 0;                               ///< bonds
    double big = 0;                                  ///< fragments of at least 1 % of their body
    double largest = 0;                              ///< share of its body, mean over the bodies
    std::vector<double> masses;                ///< of all fragments, over the mass of a body, descending
    uint32_t most_rigid = 0, most_asleep = 0;  ///< fragments, in any frame
};

/// Runs the shot for `seconds` with its ledger kept. Fails the test when a step does.
SceneOutcome outcomeOf(const Shot& shot, double seconds);

/// Share of the mass by which the fragments differ when both runs' are laid side by side, largest first: 0
/// for equal ones, towards 1 for whole bodies against dust.
double massDistance(const SceneOutcome& a, const SceneOutcome& b);

/// How far momentum strays while the shot runs without gravity and floor, so that all flies freely. Over the
/// momentum that the balls brought, and for the angular one over that times a body's height or the way of the
/// farthest particle from the origin, whichever is longer.
struct Straying {
    double linear = 0, angular = 0;
    uint32_t broken = 0, most_rigid = 0;
};
/// The shot's balls fly level for `flight` s to their bodies, and all of them start at once.
Straying strayingOf(Shot shot, double flight, uint32_t frames);

}  // namespace demolish::tests
