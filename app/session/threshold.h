// SPDX-License-Identifier: Apache-2.0
// The velocity from which a shot breaks its body: measured where it was measured once, else predicted.
#pragma once
#include <optional>
#include <string>

#include "app/session/shot.h"
#include "app/session/threshold_cache.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

struct Threshold {
    double predicted = 0;            ///< m/s, from the table
    double scatter = 1;              ///< of the prediction, as a factor
    bool is_known_body = false;      ///< the table has a row for the body
    bool is_painted = false;         ///< strength follows paint, which the table does not know
    std::optional<double> measured;  ///< m/s, mean over `packings`
    uint32_t packings = 0;
    double velocity() const { return measured.value_or(predicted); }
    /// "measured on 4 packings", "table, this body", "rule from shape and mass"; of painted bodies the last
    /// two say that they do not know the paint.
    std::string source() const;
};

/// Of the shot's velocity knob at its present strength; none if nothing hits. Looks into the user's cache.
/// Throws InputFileError (the table).
std::optional<Threshold> thresholdOf(const Shot& shot, const BreakableBody& body);

/// The critical velocity (m/s) at which the shot's threshold is `velocity`: the one that calibrate() found
/// for it, else by what was measured, else in proportion to the prediction. Throws UsageError when nothing
/// hits the body, or no material is that weak or strong.
double criticalVelocityFor(const Shot& shot, const BreakableBody& body, double velocity);
/// The same with these measurements and this prediction (m/s, at the shot's own critical velocity).
double criticalVelocityFor(const Shot& shot, double velocity, const CachedThresholds& measured,
                           double predicted);

/// Predicted v_th / v_c of this body for the impact that it bears least: dropped, or hit by the shot's ball.
/// What rigid pieces wake by.
double lowestThresholdShare(const Shot& shot, const BreakableBody& body);

}  // namespace demolish
