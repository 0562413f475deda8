// SPDX-License-Identifier: Apache-2.0
// Bracket, halve, average.
#include "app/calibrate/threshold_search.h"

#include <algorithm>
#include <cmath>

#include "app/session/shot_bodies.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kWalk = 1.5;
/// Speeds that are tried above the one that breaks, each this times the last.
constexpr double kConfirmStep = 1.15;
constexpr int kConfirmations = 3;

std::string metresPerSecond(double speed) {
    return std::to_string(speed).substr(0, 6) + " m/s";
}

/// Trials that a search takes when the guess is near: two to bracket, then halvings, then confirmations.
double usualTrials(double tolerance) {
    return 2.5 + kConfirmations + std::max(0.0, std::log2(std::log(kWalk) / std::log(1 + tolerance)));
}

/// Walks on from `speed` until one speed holds and one breaks.
void bracketFrom(double speed, const std::function<bool(double speed)>& breaks, Bracket& bracket) {
    while (!(bracket.holds > 0) || !(bracket.breaks > 0)) {
        const bool broke = breaks(speed);
        ++bracket.trials;
        (broke ? bracket.breaks : bracket.holds) = speed;
        if (bracket.holds > 0 && bracket.breaks > 0) return;
        if (broke && speed <= kThresholdRange.least)
            throw NumericalError("the body breaks at " + metresPerSecond(speed) +
                                 ", by its own weight or the ball's; choose a stronger material");
        if (!broke && speed >= kThresholdRange.most)
            throw NumericalError("the body does not break up to " + metresPerSecond(speed) +
                                 "; choose a weaker material or a larger ball");
        speed =
            std::clamp(broke ? speed / kWalk : speed * kWalk, kThresholdRange.least, kThresholdRange.most);
    }
}

/// The fastest of the confirming speeds at which the body holds after all; 0: it breaks at all of them.
double holdsAbove(const std::function<bool(double speed)>& breaks, Bracket& bracket) {
    double held = 0, speed = bracket.breaks;
    for (int k = 0; k < kConfirmations && speed * kConfirmStep <= kThresholdRange.most; ++k) {
        speed *= kConfirmStep;
        ++bracket.trials;
        if (!breaks(speed)) held = speed;
    }
    return held;
}

}  // namespace

double Bracket::threshold() const {
    return std::sqrt(holds * breaks);
}

void halveBracket(const std::function<bool(double speed)>& breaks, Bracket& bracket, double tolerance) {
    while (bracket.breaks > (1 + tolerance) * bracket.holds) {
        const double middle = bracket.threshold();
        (breaks(middle) ? bracket.breaks : bracket.holds) = middle;
        ++bracket.trials;
    }
}

Bracket searchThreshold(const std::function<bool(double speed)>& breaks, double guess, double tolerance) {
    requireInRange("the tolerance", tolerance, {0.005, 1}, "");
    Bracket bracket;
    double from = std::clamp(guess, kThresholdRange.least, kThresholdRange.most);
    for (;;) {
        bracketFrom(from, breaks, bracket);
        halveBracket(breaks, bracket, tolerance);
        const double held = holdsAbove(breaks, bracket);
        if (!(held > 0)) return bracket;
        bracket.holds = held;
        bracket.breaks = 0;
        from = std::min(held * kWalk, kThresholdRange.most);
    }
}

double MeasuredThreshold::lowest() const {
    return std::min_element(packings.begin(), packings.end(),
                            [](const Bracket& a, const Bracket& b) { return a.threshold() < b.threshold(); })
        ->threshold();
}

double MeasuredThreshold::highest() const {
    return std::max_element(packings.begin(), packings.end(),
                            [](const Bracket& a, const Bracket& b) { return a.threshold() < b.threshold(); })
        ->threshold();
}

std::vector<std::shared_ptr<const BreakableBody>> fillPackings(const Shot& shot, const SolidMesh& mesh,
                                                               uint32_t count, bool on_gpu,
                                                               const ProgressCallback& progress,
                                                               std::shared_ptr<const BreakableBody> first) {
    std::vector<std::shared_ptr<const BreakableBody>> packings;
    if (first) packings.push_back(std::move(first));
    for (auto p = static_cast<uint32_t>(packings.size()); p < count; ++p) {
        if (progress && !progress(static_cast<double>(p) / count, "filling with particles"))
            throw Cancelled();
        FillOptions options = fillOptionsOf(shot, bodiesOf(shot)[subjectOf(shot)], mesh, on_gpu);
        options.seed = shot.seed + p;
        options.draw_geometry = false;
        packings.push_back(fillWithParticles(mesh, options));
    }
    return packings;
}

MeasuredThreshold measureThreshold(const Shot& shot,
                                   const std::vector<std::shared_ptr<const BreakableBody>>& packings,
                                   const MeasureOptions& options, const ProgressCallback& progress) {
    const double usual = usualTrials(options.tolerance), count = static_cast<double>(packings.size());
    MeasuredThreshold result;
    double guess = options.guess > 0 ? options.guess : shot.material.critical_velocity;
    for (size_t p = 0; p < packings.size(); ++p) {
        double tried = 0;
        const auto tell = [&](double trials) {
            const double share = std::min(0.99, trials / usual);
            if (progress && !progress((static_cast<double>(p) + share) / count, "trying velocities"))
                throw Cancelled();
        };
        tell(0);
        Shot packed = trialShot(shot);
        packed.seed = shot.seed + p;  // where it is weak, too
        ImpactTrial trial(packed, packings[p], options.trial);
        result.packings.push_back(searchThreshold(
            [&](double speed) {
                tell(++tried);
                return trial.breaksAt(speed);
            },
            guess, options.tolerance));
        tell(tried);  // cancelled in the last trial is cancelled, too
        guess = result.packings.back().threshold();
        result.velocity += guess / count;
    }
    result.share = result.velocity / shot.material.critical_velocity;
    return result;
}

}  // namespace demolish
