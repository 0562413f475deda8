// Fillings, cache, search.
#include "app/calibrate/calibration.h"

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kFillingShare = 0.1;  // of the progress bar

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

}  // namespace

Calibration calibrate(const Shot& shot, std::shared_ptr<const BreakableBody> body,
                      const CalibrationOptions& options, const ProgressCallback& progress) {
    validate(shot);
    Calibration result;
    result.shot = shot;
    const auto mesh = loadSolidMesh(shot.model, {.height = shot.height});
    if (!body) body = fillPackings(shot, *mesh, 1, options.on_gpu, part(progress, 0, kFillingShare)).at(0);
    if (shot.break_at)
        result.shot.material.critical_velocity = criticalVelocityFor(shot, *body, *shot.break_at);
    const auto predicted = thresholdOf(result.shot, *body);
    if (!predicted) throw UsageError("nothing hits the body; choose a ball or a drop");
    result.threshold = *predicted;
    result.particles = static_cast<uint32_t>(body->particles.size());
    result.particle_size = body->spacing;
    const auto folder = thresholdCacheFolder();
    const uint64_t key = thresholdKey(shot, *body);
    if (options.use_cache)
        if (const auto cached = readCachedThreshold(folder, key);
            cached && cached->packings >= options.packings && cached->tolerance <= options.tolerance) {
            result.measured = *cached;
            result.from_cache = true;
            return result;
        }
    auto packings =
        fillPackings(shot, *mesh, options.packings, options.on_gpu, part(progress, 0, kFillingShare), body);
    const MeasuredThreshold measured = measureThreshold(
        result.shot, packings,
        {.tolerance = options.tolerance, .guess = predicted->velocity(), .trial = {options.on_gpu}},
        part(progress, kFillingShare, 1));
    for (const Bracket& bracket : measured.packings) result.trials += bracket.trials;
    result.measured = inShares(measured, result.shot, options.tolerance);
    result.threshold.measured = measured.velocity;
    result.threshold.packings = result.measured.packings;
    if (options.use_cache) writeCachedThreshold(folder, key, result.measured);
    return result;
}

}  // namespace demolish
