// SPDX-License-Identifier: Apache-2.0
// Table and cache joined.
#include "app/session/threshold.h"

#include <algorithm>
#include <cmath>

#include "app/session/threshold_table.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kCriticalVelocity{0.01, 1000};  // m/s, as in a material's file

ThresholdTable::Prediction predictionOf(const Shot& shot, const BreakableBody& body, ImpactKind kind) {
    return ThresholdTable::ofAssets().predict(shot.strength_row, shot.material,
                                              impactFeatures(shot, body, kind));
}

}  // namespace

std::string Threshold::source() const {
    if (measured)
        return "measured on " + std::to_string(packings) + (packings == 1 ? " packing" : " packings");
    const std::string from = is_known_body ? "table, this body" : "rule from shape and mass";
    return is_painted ? from + ", as if it were not painted: where it is weaker it breaks from less" : from;
}

std::optional<Threshold> thresholdOf(const Shot& shot, const BreakableBody& body) {
    if (shot.impact.kind == ImpactKind::kNone) return std::nullopt;
    const auto prediction = predictionOf(shot, body, shot.impact.kind);
    const double critical = shot.material.critical_velocity;
    Threshold threshold;
    threshold.predicted = prediction.share * critical;
    threshold.scatter = prediction.scatter;
    threshold.is_known_body = prediction.is_known;
    threshold.is_painted = !body.bond_strength.empty();
    const auto measured = readCachedThresholds(thresholdCacheFolder(), thresholdKey(shot, body));
    if (measured.empty()) return threshold;
    threshold.measured = shareAt(measured, critical) * critical;
    threshold.packings = measured.front().packings;
    for (const CachedThreshold& point : measured)
        threshold.packings = std::min(threshold.packings, point.packings);
    return threshold;
}

double criticalVelocityFor(const Shot& shot, const BreakableBody& body, double velocity) {
    const auto threshold = thresholdOf(shot, body);
    if (!threshold) throw UsageError("the velocity to break at needs an impact: choose a ball or a drop");
    const auto measured = readCachedThresholds(thresholdCacheFolder(), thresholdKey(shot, body));
    return criticalVelocityFor(shot, velocity, measured, threshold->predicted);
}

double criticalVelocityFor(const Shot& shot, double velocity, const CachedThresholds& measured,
                           double predicted) {
    if (const CachedThreshold* found = foundFor(measured, velocity)) return found->critical_velocity;
    const double critical = measured.empty() ? shot.material.critical_velocity * velocity / predicted
                                             : criticalVelocityAt(measured, velocity);
    requireInRange("the critical velocity that breaks the body as wished", critical, kCriticalVelocity,
                   "m/s");
    return critical;
}

double lowestThresholdShare(const Shot& shot, const BreakableBody& body) {
    double lowest = predictionOf(shot, body, ImpactKind::kDrop).wake_share;
    if (shot.impact.kind == ImpactKind::kBall)
        lowest = std::min(lowest, predictionOf(shot, body, ImpactKind::kBall).wake_share);
    return std::round(1000 * lowest) / 1000;  // the same on every machine, whatever its pow() gives
}

}  // namespace demolish
