// Fillings, cache, search.
#include "app/calibrate/calibration.h"

#include <cmath>
#include <utility>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kFillingShare = 0.1;  // of the progress bar
/// Strengths that are tried for a velocity to break at, and how near the threshold must come to it.
constexpr int kMostRounds = 4;
constexpr double kBreakAtTolerance = 0.05;

ProgressCallback part(const ProgressCallback& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double fraction, const char* stage) {
        return progress(from + (to - from) * fraction, stage);
    };
}

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

/// Measures a shot at the strengths that it is asked for, one after the other.
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
            found && found->packings >= options_.packings && found->tolerance <= options_.tolerance)
            return *found;
        if (packings_.empty())
            packings_ =
                fillPackings(shot_, *loadSolidMesh(shot_.model, {.height = shot_.height}), options_.packings,
                             options_.on_gpu, part(progress_, 0, kFillingShare), body_);
        const MeasuredThreshold measured = measureThreshold(
            shot, packings_, {.tolerance = options_.tolerance, .guess = guess, .trial = {options_.on_gpu}},
            part(progress_, kFillingShare, 1));
        for (const Bracket& bracket : measured.packings) result.trials += bracket.trials;
        const CachedThreshold shares = inShares(measured, shot, options_.tolerance);
        keep(shares, known_);
        if (options_.use_cache) writeCachedThreshold(folder_, key_, shares);
        return shares;
    }
    const CachedThresholds& known() const { return known_; }

  private:
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

Calibration calibrate(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                      const CalibrationOptions& options, const ProgressCallback& progress) {
    validate(shot);
    Calibration result;
    result.shot = shot;
    if (!body)
        body = fillPackings(shot, *loadSolidMesh(shot.model, {.height = shot.height}), 1, options.on_gpu,
                            part(progress, 0, kFillingShare))
                   .at(0);
    Measuring measuring(shot, body, options, progress);
    const auto predicted = thresholdOf(shot, *body);
    if (!predicted) throw UsageError("nothing hits the body; choose a ball or a drop");
    double& critical = result.shot.material.critical_velocity;
    const double predicted_share = predicted->predicted / critical;
    double guess = predicted->velocity();
    for (int round = 0; round < (shot.break_at ? kMostRounds : 1); ++round) {
        if (shot.break_at) {
            critical = criticalVelocityFor(shot, *shot.break_at, measuring.known(), predicted->predicted);
            guess = *shot.break_at;
        }
        result.measured = measuring.at(result.shot, guess, result);
        if (shot.break_at && std::abs(result.velocity() / *shot.break_at - 1) <= kBreakAtTolerance) break;
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
