// SPDX-License-Identifier: Apache-2.0
// The speed at which an impact just breaks a body, by geometric bisection.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "app/calibrate/impact_trial.h"
#include "app/session/built_shot.h"

namespace demolish {

/// m/s. The body held at `holds` and broke at `breaks`; 0 and infinity where the search found no end.
struct Bracket {
    double holds = 0, breaks = 0;
    uint32_t trials = 0;
    /// Geometric mean of both ends.
    double threshold() const;
};

/// Speeds between which a threshold is looked for, m/s.
inline constexpr Range kThresholdRange{0.01, 200};

/// Walks from `guess` in steps of half as much again until one speed holds and the next breaks, then halves
/// until breaks/holds <= 1 + tolerance. Then three speeds up to half as fast again are tried: a ball that
/// shatters a vase at one speed may only punch a hole at a higher one, and what is asked for is from which
/// speed on the body breaks. Where it holds, the search goes on from there. Throws UsageError on a tolerance
/// outside 0.005..1; NumericalError when the body breaks at kThresholdRange.least or holds at
/// kThresholdRange.most.
Bracket searchThreshold(const std::function<bool(double speed)>& breaks, double guess, double tolerance);

/// Halves a bracket that has both ends until breaks/holds <= 1 + tolerance.
void halveBracket(const std::function<bool(double speed)>& breaks, Bracket& bracket, double tolerance);

struct MeasureOptions {
    double tolerance = 0.05;  ///< of the bracket, as a share
    double guess = 0;         ///< m/s; 0: the material's critical velocity
    TrialOptions trial;
};

/// A measured threshold: of one body at one setting, mean over its packings.
struct MeasuredThreshold {
    double velocity = 0;            ///< m/s, mean
    double share = 0;               ///< velocity / v_c
    std::vector<Bracket> packings;  ///< one a packing
    double lowest() const;          ///< m/s, threshold of the weakest packing
    double highest() const;         ///< m/s, of the strongest
};

/// Fillings of the shot's model with the seeds shot.seed, shot.seed + 1, ...; `first`: the first of them, if
/// there is one already. Throws as fillWithParticles.
std::vector<std::shared_ptr<const BreakableBody>> fillPackings(
    const Shot& shot, const SolidMesh& mesh, uint32_t count, bool on_gpu, const ProgressCallback& progress,
    std::shared_ptr<const BreakableBody> first = {});

/// `packings` as fillPackings() makes them of the shot. Throws what ImpactTrial and searchThreshold throw.
MeasuredThreshold measureThreshold(const Shot& shot,
                                   const std::vector<std::shared_ptr<const BreakableBody>>& packings,
                                   const MeasureOptions& options, const ProgressCallback& progress);

}  // namespace demolish
