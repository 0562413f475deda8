// Judge a strength at fixed speeds, walk, halve, look around.
#include "app/calibrate/strength_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kAbove = 1 + kBreakAtMargin, kBelow = 1 - kBreakAtMargin;
/// Nearer than what is promised: where chance allows, the threshold lies in the middle.
constexpr double kNearAbove = 1.05, kNearBelow = 0.95;
/// Speeds over the one asked for, the most telling first; the body is to break at those above 1 only.
constexpr std::array kProbes{kAbove, kBelow, kNearAbove, kNearBelow, 1.21, 0.8, 1.33, 1.46, 1.61};

/// m/s: its probes must lie where thresholds are looked for.
constexpr Range kSearchedVelocity{kThresholdRange.least / 0.8, kThresholdRange.most / kAbove};

constexpr double kFirstStep = 1.25, kStepGrowth = 1.2, kMostStep = 2;
constexpr int kMostSteps = 10;
/// Strengths nearer to each other than this differ by chance.
constexpr double kNearest = 1.02;
/// Around the place where too weak and too strong meet: so many strengths to each side, that far apart.
constexpr int kAround = 6;
constexpr double kAroundStep = 1.025;
/// Trials after which the progress bar has gone two thirds of its way; a search has no known end.
constexpr double kUsualTrials = 12;

struct Verdict {
    int passed = 0;  ///< probes that went as wished, before the first that did not
    bool met = true, too_strong = false;
};

class Search {
  public:
    Search(const std::function<bool(double, double)>& breaks, double velocity)
        : breaks_(breaks), velocity_(velocity) {}

    StrengthFound find(double guess, double tolerance) {
        StrengthFound found;
        found.critical = bracketFrom(guess);
        if (!(found.critical > 0)) found.critical = halve();
        if (found.critical > 0) {
            found.met = true;
            found.bracket = {kNearBelow * velocity_, kNearAbove * velocity_, 0};
        } else {
            found.met = lookAround(found.critical);
            found.bracket = {kBelow * velocity_, kAbove * velocity_, 0};
        }
        const auto at_found = [&](double speed) { return breaksAt(found.critical, speed); };
        if (found.met)
            halveBracket(at_found, found.bracket, tolerance);
        else
            found.bracket = searchThreshold(at_found, velocity_, tolerance);
        found.bracket.trials = trials_;
        return found;
    }

  private:
    bool breaksAt(double critical, double speed) {
        ++trials_;
        return breaks_(critical, speed);
    }

    /// `centred`: with the two probes that are nearer than what is promised.
    Verdict judge(double critical, bool centred) {
        Verdict verdict;
        for (const double probe : kProbes) {
            if (!centred && probe > kBelow && probe < kAbove) continue;
            const double speed = probe * velocity_;
            const bool wished = probe > 1;
            if (speed <= kThresholdRange.most && breaksAt(critical, speed) != wished) {
                verdict.met = false;
                verdict.too_strong = wished;
                return verdict;
            }
            ++verdict.passed;
        }
        return verdict;
    }

    /// The strength at which all goes as wished; 0: one is known that is too weak and one too strong.
    double bracketFrom(double critical) {
        double step = kFirstStep;
        for (int k = 0; k < kMostSteps; ++k) {
            const Verdict verdict = judge(critical, true);
            if (verdict.met) return critical;
            (verdict.too_strong ? strong_ : weak_) = critical;
            if (weak_ > 0 && strong_ > 0) return 0;
            critical *= verdict.too_strong ? 1 / step : step;
            step = std::min(kMostStep, step * kStepGrowth);
        }
        throw NumericalError("no strength was found at which the body breaks from " +
                             std::to_string(velocity_).substr(0, 6) + " m/s on: it " +
                             (weak_ > 0 ? "breaks at less, however strong" : "holds, however weak"));
    }

    /// The same between these two; 0: there is none that differs from both.
    double halve() {
        while (strong_ > kNearest * weak_) {
            const double middle = std::sqrt(weak_ * strong_);
            const Verdict verdict = judge(middle, true);
            if (verdict.met) return middle;
            (verdict.too_strong ? strong_ : weak_) = middle;
        }
        return 0;
    }

    /// From where too weak and too strong meet, outwards: is the promise kept? The one that came farthest.
    bool lookAround(double& best) {
        const double centre = std::sqrt(weak_ * strong_);
        int farthest = -1;
        for (int k = 0; k <= 2 * kAround; ++k) {
            const double critical = centre * std::pow(kAroundStep, (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2));
            const Verdict verdict = judge(critical, false);
            if (verdict.passed > farthest) {
                farthest = verdict.passed;
                best = critical;
            }
            if (verdict.met) return true;
        }
        return false;
    }

    const std::function<bool(double, double)>& breaks_;
    double velocity_;
    double weak_ = 0, strong_ = 0;  // v_c, m/s; 0: none yet
    uint32_t trials_ = 0;
};

}  // namespace

StrengthFound searchStrength(const std::function<bool(double critical, double speed)>& breaks,
                             double velocity, double guess, double tolerance) {
    requireInRange("the tolerance", tolerance, {0.005, 1}, "");
    requireInRange("the velocity to break at", velocity, kSearchedVelocity, "m/s");
    return Search(breaks, velocity).find(guess, tolerance);
}

MeasuredStrength measureStrength(const Shot& shot, const std::shared_ptr<const BreakableBody>& body,
                                 double velocity, const MeasureOptions& options,
                                 const ProgressCallback& progress) {
    double tried = 0;
    const auto tell = [&] {
        if (progress && !progress(1 - std::exp(-tried / kUsualTrials), "trying strengths")) throw Cancelled();
    };
    Shot single = trialShot(shot);
    std::optional<ImpactTrial> trial;  // at the present strength: a body settles anew at every one
    MeasuredStrength result;
    result.found = searchStrength(
        [&](double critical, double speed) {
            tell();
            ++tried;
            if (!trial || single.material.critical_velocity != critical) {
                single.material.critical_velocity = critical;
                trial.emplace(single, body, options.trial);
            }
            return trial->breaksAt(speed);
        },
        velocity, options.guess, options.tolerance);
    tell();  // cancelled in the last trial is cancelled, too
    result.threshold.packings = {result.found.bracket};
    result.threshold.velocity = result.found.bracket.threshold();
    result.threshold.share = result.threshold.velocity / result.found.critical;
    return result;
}

}  // namespace demolish
