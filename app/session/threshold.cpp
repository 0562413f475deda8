// Table and cache joined.
#include "app/session/threshold.h"

#include <algorithm>
#include <cmath>

#include "app/session/threshold_cache.h"
#include "app/session/threshold_table.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kCriticalVelocity{0.01, 1000};  // m/s, as in a material's file

ThresholdTable::Prediction predictionOf(const Shot& shot, const BreakableBody& body, ImpactKind kind) {
    return ThresholdTable::ofAssets().predict(shot.model.stem().string(), shot.material,
                                              impactFeatures(shot, body, kind));
}

}  // namespace

std::string Threshold::source() const {
    if (measured)
        return "measured on " + std::to_string(packings) + (packings == 1 ? " packing" : " packings");
    return is_known_body ? "table, this body" : "rule from shape and mass";
}

std::optional<Threshold> thresholdOf(const Shot& shot, const BreakableBody& body) {
    if (shot.impact.kind == ImpactKind::kNone) return std::nullopt;
    const auto prediction = predictionOf(shot, body, shot.impact.kind);
    const double critical = shot.material.critical_velocity;
    Threshold threshold;
    threshold.predicted = prediction.share * critical;
    threshold.scatter = prediction.scatter;
    threshold.is_known_body = prediction.is_known;
    if (const auto cached = readCachedThreshold(thresholdCacheFolder(), thresholdKey(shot, body))) {
        threshold.measured = cached->share * critical;
        threshold.packings = cached->packings;
    }
    return threshold;
}

double criticalVelocityFor(const Shot& shot, const BreakableBody& body, double velocity) {
    const auto threshold = thresholdOf(shot, body);
    if (!threshold) throw UsageError("the velocity to break at needs an impact: choose a ball or a drop");
    const double critical = shot.material.critical_velocity * velocity / threshold->velocity();
    requireInRange("the critical velocity that breaks the body as wished", critical, kCriticalVelocity,
                   "m/s");
    return critical;
}

double lowestThresholdShare(const Shot& shot, const BreakableBody& body) {
    double lowest = predictionOf(shot, body, ImpactKind::kDrop).share;
    if (shot.impact.kind == ImpactKind::kBall)
        lowest = std::min(lowest, predictionOf(shot, body, ImpactKind::kBall).share);
    return std::round(1000 * lowest) / 1000;  // the same on every machine, whatever its pow() gives
}

}  // namespace demolish
