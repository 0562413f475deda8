// SPDX-License-Identifier: Apache-2.0
// Shots for which a substep of half the critical step is too long.
#pragma once
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Spacings in a substep. With 0.15 one of 5,400 random shots, vases of two cells, still found 3.5 %.
inline constexpr double kFarthestStep = 0.1;
/// Radii of a ball in a substep. One that went half of its own found 2.6 %, with two fifths 0.1 %.
inline constexpr double kFarthestBall = 1.0 / 3;

/// What will be shot at the bodies.
struct ShotsToCome {
    double speed = 0;      ///< m/s, of the fastest
    double radius = 1e30;  ///< m, of the smallest
};

/// Divides the substeps of `setup` where half the critical step leaves the books open, and leaves bonds as
/// soft as the undivided ones make them; to no more than kSubstepRange allows.
/// - In two for rubber, that stretches by more than a tenth before it breaks: its bonds and contacts turn by
///   much in a substep, and cells sink into each other until the dampers of many contacts overshoot together.
/// - In two for a cell of many spacings' length. It turns so easily that its bonds and the corners that it
///   lands on, each stable by itself, are not stable together.
/// - Into as many as it takes that nothing comes farther in a substep than kFarthestStep, and no ball
///   farther than kFarthestBall: else a hit is over in a few of them, and gains or loses up to a
///   third of its energy.
void divideSteps(SceneSetup& setup, const ShotsToCome& shots);
/// Would divideSteps() divide a setup that it has divided otherwise, for these shots?
bool dividesOtherwise(const SceneSetup& divided, const ShotsToCome& shots);

}  // namespace demolish
