// SPDX-License-Identifier: Apache-2.0
// Fillings, cache, search.
#include "app/calibrate/calibration.h"

#include <cmath>
#include <utility>

#include "app/calibrate/strength_search.h"
#include "app/reading/model_reader.h"
#include "app/session/progress_part.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_setup.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kFillingShare = 0.1;  // of the progress bar
/// Strengths that are tried until a mean threshold is the velocity to break at, and how near is near enough.
constexpr int kMostRounds = 4;
constexpr double kBreakAtTolerance = 0.05;

CachedThreshold inShares(const MeasuredThreshold& measured, const Shot& shot, double tolerance) {
    const double critical = shot.material.critical_velocity;
    CachedThreshold shares;
    shares.share = measured.share;
    shares.lowest = measured.lowest() / critical;
    shares.highest = measured.highest() / critical;
    shares.critical_velocity = critical;
    shares.packings = static_cast<uint32_t>(measured.packings.size());
    shares.tolerance = tolerance;
    return shares;
}

/// Measures a shot at the strengths that it is asked for, one after the other, or finds the strength.
class Measuring {
  public:
    Measuring(const Shot& shot, std::shared_ptr<const BreakableBody> body, const CalibrationOptions& options,
              const ProgressCallback& progress)
        : shot_(shot),
          body_(std::move(body)),
          options_(options),
          progress_(progress),
          folder_(thresholdCacheFolder()),
          key_(thresholdKey(shot, *body_)) {
        if (options.use_cache) known_ = readCachedThresholds(folder_, key_);
    }

    /// In shares of v_c, at the shot's present strength; counts into `result` what it simulates.
    CachedThreshold at(const Shot& shot, double guess, Calibration& result) {
        if (const CachedThreshold* found = measuredAt(known_, shot.material.critical_velocity);
            found && isEnough(*found))
            return *found;
        if (packings_.empty())
            packings_ =
                fillPackings(shot_, *readSolidMesh(shot_.model, placementOf(shot_), progress_),
                             options_.packings, options_.on_gpu, part(progress_, 0, kFillingShare), body_);
        const MeasuredThreshold measured = measureThreshold(
            shot, packings_, {.tolerance = options_.tolerance, .guess = guess, .trial = {options_.on_gpu}},
            part(progress_, kFillingShare, 1));
        for (const Bracket& bracket : measured.packings) result.trials += bracket.trials;
        const CachedThreshold shares = inShares(measured, shot, options_.tolerance);
        remember(shares);
        return shares;
    }

    /// The same at the strength at which the body breaks at Shot::break_at; `predicted` at the shot's, m/s.
    CachedThreshold atBreaking(double predicted, Calibration& result) {
        if (const CachedThreshold* found = foundFor(known_, *shot_.break_at); found && isEnough(*found))
            return *found;
        CachedThreshold shares =
            options_.packings == 1 ? byStrength(predicted, result) : byCorrection(predicted, result);
        shares.break_at = *shot_.break_at;
        remember(shares);
        return shares;
    }

  private:
    bool isEnough(const CachedThreshold& known) const {
        return known.packings >= options_.packings && known.tolerance <= options_.tolerance;
    }

    void remember(const CachedThreshold& shares) {
        keep(shares, known_);
        if (options_.use_cache) writeCachedThreshold(folder_, key_, shares);
    }

    CachedThreshold byStrength(double predicted, Calibration& result) {
        const MeasuredStrength measured =
            measureStrength(shot_, body_, *shot_.break_at,
                            {.tolerance = options_.tolerance,
                             .guess = criticalVelocityFor(shot_, *shot_.break_at, known_, predicted),
                             .trial = {options_.on_gpu}},
                            part(progress_, kFillingShare, 1));
        result.trials += measured.found.bracket.trials;
        Shot found = shot_;
        found.material.critical_velocity = measured.found.critical;
        return inShares(measured.threshold, found, options_.tolerance);
    }

    CachedThreshold byCorrection(double predicted, Calibration& result) {
        const double wanted = *shot_.break_at;
        for (CachedThreshold& point : known_) point.break_at = 0;  // found for fewer packings
        const auto miss = [&](const CachedThreshold& point) {
            return std::abs(point.share * point.critical_velocity / wanted - 1);
        };
        CachedThreshold best;
        Shot tried = shot_;
        for (int round = 0; round < kMostRounds; ++round) {
            tried.material.critical_velocity = criticalVelocityFor(shot_, wanted, known_, predicted);
            const CachedThreshold measured = at(tried, wanted, result);
            if (round == 0 || miss(measured) < miss(best)) best = measured;
            if (miss(best) <= kBreakAtTolerance) break;
        }
        return best;
    }

    const Shot& shot_;
    std::shared_ptr<const BreakableBody> body_;
    const CalibrationOptions& options_;
    const ProgressCallback& progress_;
    std::filesystem::path folder_;
    uint64_t key_;
    CachedThresholds known_;
    std::vector<std::shared_ptr<const BreakableBody>> packings_;
};

}  // namespace

bool Calibration::meetsBreakAt() const {
    return !shot.break_at || std::abs(velocity() / *shot.break_at - 1) <= kBreakAtMargin;
}

Calibration calibrate(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                      const CalibrationOptions& options, const ProgressCallback& progress) {
    validate(shot);
    Calibration result;
    result.shot = shot;
    if (!body)
        body = fillPackings(shot, *readSolidMesh(shot.model, placementOf(shot), progress), 1, options.on_gpu,
                            part(progress, 0, kFillingShare))
                   .at(0);
    Measuring measuring(shot, body, options, progress);
    const auto predicted = thresholdOf(shot, *body);
    if (!predicted) throw UsageError("nothing hits the body; choose a ball or a drop");
    double& critical = result.shot.material.critical_velocity;
    const double predicted_share = predicted->predicted / critical;
    if (shot.break_at) {
        result.measured = measuring.atBreaking(predicted->predicted, result);
        critical = result.measured.critical_velocity;
    } else {
        result.measured = measuring.at(shot, predicted->velocity(), result);
    }
    result.threshold = *predicted;
    result.threshold.predicted = predicted_share * critical;
    result.threshold.measured = result.velocity();
    result.threshold.packings = result.measured.packings;
    result.from_cache = result.trials == 0;
    result.particles = static_cast<uint32_t>(body->particles.size());
    result.particle_size = body->spacing;
    return result;
}

}  // namespace demolish
