// SPDX-License-Identifier: Apache-2.0
// One body of a shot, alone, hit again and again at chosen speeds: does it break?
#pragma once
#include <memory>

#include "app/session/ball_flight.h"
#include "app/session/shot.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// "Broken" (models.md E.2): the largest piece holds less than kIntactShare of the mass and at least two
/// pieces hold kPieceShare each, or none holds kCrushedShare, as where all is dust; looked for during
/// trialSeconds() from the first touch on.
inline constexpr double kIntactShare = 0.8, kPieceShare = 0.01, kCrushedShare = 0.5;

/// s. 0.1 (models.md E.2), but as long as the impact takes where it is slow: until the ball has gone twice
/// the body's height, to the far wall of a hollow body, or a dropped body half its own, so that its other
/// edge has struck; 0.5 at most. `height` in m, `speed` in m/s. A trial goes on while bonds still break, to 1
/// s.
inline constexpr double kLeastTrial = 0.1, kLongestTrial = 0.5;
double trialSeconds(ImpactKind kind, double height, double speed);

/// The shot reduced to the one impact that a threshold speaks of: the body that the fastest ball hits (the
/// first one, for a drop) and that ball. Hand-over and sleeping are off. A body that is hit stands under its
/// weight; one that is dropped weighs nothing during the trial: in 0.1 s it would fall by 5 cm, more than the
/// fall that breaks a fragile body, and its threshold would no longer be proportional to its strength.
Shot trialShot(const Shot& shot);

struct TrialOptions {
    bool on_gpu = false;
    /// Substeps that many times as many and as long at the same stiffness: how far the result hangs on the
    /// step.
    uint32_t finer_steps = 1;
};

class ImpactTrial {
  public:
    /// `shot` as trialShot() gives it, `body` one filling of its model. A ball's trials share one solver,
    /// settled once; a drop's speed is part of the set-up. Throws the solver's errors, Cancelled.
    ImpactTrial(const Shot& shot, std::shared_ptr<const BreakableBody> body, const TrialOptions& options,
                const ProgressCallback& progress = {});

    /// `speed` (m/s) is what the shot's velocity knob would be set to. Throws NumericalError when the state
    /// blows up.
    bool breaksAt(double speed);

    /// The ball of a trial at this speed (m/s), clear of all particles where that takes less than 0.02 s.
    ThrownBall ballAt(double speed) const;

    /// kg, of the body and of the ball; the ball's is 0 for a drop.
    double bodyMass() const;
    double ballMass() const;
    /// s simulated by all trials so far.
    double simulated() const { return simulated_; }
    const SceneSetup& setup() const { return setup_; }

  private:
    std::unique_ptr<Solver> makeSolver(const ProgressCallback& progress) const;
    void placeAboveFloor(double speed);
    bool broken(Solver& solver) const;

    Shot shot_;
    TrialOptions options_;
    SceneSetup setup_;
    double beyond_ = 0;               ///< m, by which particles reach beyond the surface
    std::unique_ptr<Solver> solver_;  ///< of the balls
    Snapshot start_;
    double simulated_ = 0;
};

}  // namespace demolish
