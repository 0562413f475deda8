// SPDX-License-Identifier: Apache-2.0
// The other way round: the strength at which a body breaks from a given speed on.
#pragma once
#include <functional>
#include <memory>

#include "app/calibrate/threshold_search.h"

namespace demolish {

/// How near "break at v" must come: broken at (1 + this) v and whole at (1 - this) v.
inline constexpr double kBreakAtMargin = 0.1;

struct StrengthFound {
    double critical = 0;  ///< m/s, v_c
    Bracket bracket;      ///< at that strength, m/s; its trials are those of the whole search
    bool met = false;     ///< whole at 0.9 of the velocity, broken at 1.1 and at all that was tried above
};

/// Tries strengths at fixed speeds about `velocity` (m/s): whole at 0.9, 0.8 and 0.7 of it, broken at 1.1,
/// 1.21, 1.33, 1.46 and 1.61 times it; first at 0.95 and 1.05, too, so that the threshold lies in the middle.
/// A body's answer to the speed has gaps (it breaks at 8.5 m/s, holds at 8.9 and breaks again), so that
/// thresholds measured at two strengths need not lie to either side of what is asked for though a strength
/// between them does it, and one speed alone says little: too strong is what holds at two of the first three
/// above, too weak what breaks at two of the three below. Walks from `guess` (m/s, v_c) until one strength is
/// too weak and one too strong, halves between them to 2 %, then looks around by 2.5 %, to 16 %. Where none
/// kept the promise, the one that came farthest through those speeds, or one with a threshold nearer to what
/// is asked for, as searchThreshold() measures it. `breaks`: at this strength and speed, m/s both.
/// `tolerance`: of the bracket. Throws NumericalError when the strengths tried, 1/200 to 200 times the guess
/// at most, are all too weak or all too strong; UsageError on a velocity below 0.0143 or above 181 m/s; as
/// searchThreshold().
StrengthFound searchStrength(const std::function<bool(double critical, double speed)>& breaks,
                             double velocity, double guess, double tolerance);

struct MeasuredStrength {
    StrengthFound found;
    MeasuredThreshold threshold;  ///< at that strength
};
/// The same by trials of `body`, the shot's own packing; `options.guess` is the strength to begin with, m/s.
/// Throws what ImpactTrial and searchStrength throw; Cancelled.
MeasuredStrength measureStrength(const Shot& shot, const std::shared_ptr<const BreakableBody>& body,
                                 double velocity, const MeasureOptions& options,
                                 const ProgressCallback& progress);

}  // namespace demolish
