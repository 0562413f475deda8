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
};

/// With Shot::break_at the strength is sought at which the threshold is that velocity: by what was measured
/// before, else by the prediction, and anew from each measurement until it is met within 5 % or four were
/// made. `body`: the shot's own filling, if there is one already; else it is made. Throws UsageError when
/// nothing hits the body, the errors of authoring, solver and cache; Cancelled.
Calibration calibrate(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                      const CalibrationOptions& options, const ProgressCallback& progress);

}  // namespace demolish
