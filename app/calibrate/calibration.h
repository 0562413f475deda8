// SPDX-License-Identifier: Apache-2.0
// A shot's threshold by simulation, looked up in the user's cache first and kept there afterwards.
#pragma once
#include "app/calibrate/threshold_search.h"
#include "app/session/threshold.h"
#include "app/session/threshold_cache.h"

namespace demolish {

struct CalibrationOptions {
    uint32_t packings = 1;
    double tolerance = 0.05;
    bool use_cache = true;
    bool on_gpu = false;
};

struct Calibration {
    Shot shot;                 ///< with the strength that Shot::break_at asks for
    CachedThreshold measured;  ///< in shares of v_c
    bool from_cache = false;   ///< nothing was simulated now
    Threshold threshold;       ///< m/s, prediction beside the measurement, at that strength
    uint32_t particles = 0;
    double particle_size = 0;  ///< m
    uint32_t trials = 0;       ///< simulations made now
    double velocity() const { return measured.share * shot.material.critical_velocity; }
    /// The threshold is within kBreakAtMargin of Shot::break_at; true without one.
    bool meetsBreakAt() const;
};

/// With Shot::break_at the strength is sought at which the body breaks from that velocity on, beginning with
/// what was measured before, else with the prediction: by searchStrength() for one packing. The mean of
/// several is measured, corrected and measured again until it is met within 5 % or four were made, and the
/// nearest is taken. The cache keeps what was found: the same velocity gives the same strength again
/// everywhere. `body`: the shot's own filling, if there is one already; else it is made. Throws UsageError
/// when nothing hits the body, the errors of authoring, solver and cache; Cancelled.
Calibration calibrate(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                      const CalibrationOptions& options, const ProgressCallback& progress);

}  // namespace demolish
