// SPDX-License-Identifier: Apache-2.0
// Judge a strength at fixed speeds, walk, halve, look around.
#include "app/calibrate/strength_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kAbove = 1 + kBreakAtMargin, kBelow = 1 - kBreakAtMargin;
/// Nearer than what is promised: where chance allows, the threshold lies in the middle.
constexpr double kNearAbove = 1.05, kNearBelow = 0.95;
/// Speeds over the one asked for; the body is to break at those above 1 only. First what makes the lowest one
/// "from which on the body breaks": so many are promised.
constexpr std::array kProbes{kAbove, kBelow, 1.21, 1.33, 1.46, 1.61, 0.8, 0.7};
constexpr int kAll = static_cast<int>(kProbes.size()), kPromised = 6;

/// m/s: its probes must lie where thresholds are looked for.
constexpr Range kSearchedVelocity{kThresholdRange.least / 0.7, kThresholdRange.most / kAbove};

constexpr double kFirstStep = 1.25, kStepGrowth = 1.2, kMostStep = 2;
constexpr int kMostSteps = 10;
/// Strengths nearer to each other than this differ by chance.
constexpr double kNearest = 1.02;
/// Around the place where too weak and too strong meet: so many strengths to each side, that far apart.
constexpr int kAround = 6;
constexpr double kAroundStep = 1.025;
/// Strengths that are tried where only the threshold can be met.
constexpr int kCorrections = 4;
/// Trials after which the progress bar has gone two thirds of its way; a search has no known end.
constexpr double kUsualTrials = 12;

enum class Verdict { kTooWeak, kTooStrong, kMet };

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
        if (found.met)
            halveBracket([&](double speed) { return breaksAt(found.critical, speed); }, found.bracket,
                         tolerance);
        else
            bringThresholdNear(found, tolerance);
        found.bracket.trials = trials_;
        return found;
    }

  private:
    bool breaksAt(double critical, double speed) {
        ++trials_;
        return breaks_(critical, speed);
    }

    /// At one of the probes or nearer, over the velocity asked for; not tried twice.
    bool breaksAtShare(double critical, double share) {
        if (critical != judged_) answers_.clear();
        judged_ = critical;
        const auto known = answers_.find(share);
        if (known != answers_.end()) return known->second;
        const double speed = share * velocity_;
        return answers_[share] = speed > kThresholdRange.most || breaksAt(critical, speed);
    }

    /// What two of three say: one alone may lie in a gap.
    bool mostlyBreaks(double critical, double a, double b, double c) {
        const bool first = breaksAtShare(critical, a);
        return first == breaksAtShare(critical, b) ? first : breaksAtShare(critical, c);
    }

    /// Probes that go as wished before the first that does not.
    int passed(double critical) {
        int count = 0;
        while (count < kAll && breaksAtShare(critical, kProbes[count]) == (kProbes[count] > 1)) ++count;
        return count;
    }

    Verdict judge(double critical) {
        if (!mostlyBreaks(critical, kAbove, 1.21, 1.33)) return Verdict::kTooStrong;
        if (mostlyBreaks(critical, kBelow, 0.8, 0.7)) return Verdict::kTooWeak;
        for (const double share : {kAbove, kNearAbove})
            if (!breaksAtShare(critical, share)) return Verdict::kTooStrong;
        for (const double share : {kBelow, kNearBelow})
            if (breaksAtShare(critical, share)) return Verdict::kTooWeak;
        const int count = passed(critical);
        if (count == kAll) return Verdict::kMet;
        return kProbes[count] > 1 ? Verdict::kTooStrong : Verdict::kTooWeak;
    }

    /// The strength at which all goes as wished; 0: one is known that is too weak and one too strong.
    double bracketFrom(double critical) {
        double step = kFirstStep;
        for (int k = 0; k < kMostSteps; ++k) {
            const Verdict verdict = judge(critical);
            if (verdict == Verdict::kMet) return critical;
            const bool too_strong = verdict == Verdict::kTooStrong;
            (too_strong ? strong_ : weak_) = critical;
            if (weak_ > 0 && strong_ > 0) return 0;
            critical *= too_strong ? 1 / step : step;
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
            const Verdict verdict = judge(middle);
            if (verdict == Verdict::kMet) return middle;
            (verdict == Verdict::kTooStrong ? strong_ : weak_) = middle;
        }
        return 0;
    }

    /// From where too weak and too strong meet, outwards: is the promise kept? The one that came farthest.
    bool lookAround(double& best) {
        const double centre = std::sqrt(weak_ * strong_);
        int farthest = -1;
        for (int k = 0; k <= 2 * kAround && farthest < kAll; ++k) {
            const double critical = centre * std::pow(kAroundStep, (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2));
            const int count = passed(critical);
            if (count <= farthest) continue;
            farthest = count;
            best = critical;
        }
        return farthest >= kPromised;
    }

    /// Threshold over the velocity asked for, as everywhere: the speed from which on the body breaks.
    double measureShare(StrengthFound& at, double tolerance) {
        at.bracket =
            searchThreshold([&](double speed) { return breaksAt(at.critical, speed); }, velocity_, tolerance);
        return at.bracket.threshold() / velocity_;
    }

    /// The promise cannot be kept; the threshold may still be the one asked for. In proportion, then halved
    /// between a strength that is too weak and one too strong; the nearest.
    void bringThresholdNear(StrengthFound& found, double tolerance) {
        StrengthFound tried = found;
        double share = measureShare(tried, tolerance), nearest = share, weak = 0, strong = 0;
        found = tried;
        for (int k = 0; k < kCorrections && std::abs(nearest - 1) > 0.5 * kBreakAtMargin; ++k) {
            (share < 1 ? weak : strong) = tried.critical;
            tried.critical = weak > 0 && strong > 0 ? std::sqrt(weak * strong) : tried.critical / share;
            share = measureShare(tried, tolerance);
            if (std::abs(share - 1) >= std::abs(nearest - 1)) continue;
            nearest = share;
            found = tried;
        }
    }

    const std::function<bool(double, double)>& breaks_;
    double velocity_;
    double weak_ = 0, strong_ = 0;  // v_c, m/s; 0: none yet
    uint32_t trials_ = 0;
    double judged_ = 0;  // the strength that answers_ speak of
    std::map<double, bool> answers_;
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
