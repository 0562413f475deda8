// SPDX-License-Identifier: Apache-2.0
// The search in strength by itself, on bodies whose answer is a formula.
#include "app/calibrate/strength_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

using Answer = std::function<bool(double critical, double speed)>;

/// A body whose threshold is a multiple of its strength.
Answer proportional(double share) {
    return [share](double critical, double speed) { return speed >= share * critical; };
}

void expectKept(const StrengthFound& found, const Answer& breaks, double velocity) {
    EXPECT_TRUE(found.met);
    EXPECT_FALSE(breaks(found.critical, 0.9 * velocity)) << "v_c " << found.critical;
    EXPECT_TRUE(breaks(found.critical, 1.1 * velocity)) << "v_c " << found.critical;
    EXPECT_NEAR(found.bracket.threshold() / velocity, 1, 0.1);
    EXPECT_FALSE(breaks(found.critical, found.bracket.holds));
    EXPECT_TRUE(breaks(found.critical, found.bracket.breaks));
    EXPECT_LE(found.bracket.breaks / found.bracket.holds, 1.03 + 1e-12);
}

TEST(StrengthSearch, FindsTheStrengthFromAnyGuess) {
    for (const double share : {0.05, 0.4, 2.0, 9.0})
        for (const double off : {0.03, 0.6, 1.0, 1.9, 40.0}) {
            const Answer breaks = proportional(share);
            const StrengthFound found = searchStrength(breaks, 6, off * 6 / share, 0.03);
            expectKept(found, breaks, 6);
            EXPECT_NEAR(found.bracket.threshold() / 6, 1, 0.05);
        }
}

TEST(StrengthSearch, AGoodGuessTakesFewTrials) {
    for (const auto& [guess, most] : {std::pair{12.0, 12u}, std::pair{13.0, 24u}}) {
        uint32_t trials = 0;
        const StrengthFound found = searchStrength(
            [&](double critical, double speed) {
                ++trials;
                return speed >= 0.5 * critical;
            },
            6, guess, 0.05);
        EXPECT_EQ(found.bracket.trials, trials);
        EXPECT_LE(trials, most) << guess;
    }
}

/// As the wolf's: two kinds of break, so that the threshold jumps from 0.8 to 1.15 of what is asked for at a
/// strength of 14.2; from 14.9 to 15.1 a strength does it, far from where thresholds beside it point to.
TEST(StrengthSearch, FindsAStrengthBesideAJump) {
    const double velocity = 9.7;
    const auto threshold = [&](double critical) {
        if (critical < 14.2) return 0.8 * velocity * critical / 14.2;
        if (critical > 14.9 && critical < 15.4) return velocity * critical / 15.15;
        return 1.15 * velocity * critical / 14.2;
    };
    const Answer breaks = [&](double critical, double speed) { return speed >= threshold(critical); };
    for (const double guess : {10.0, 13.9, 14.9, 20.0})
        expectKept(searchStrength(breaks, velocity, guess, 0.03), breaks, velocity);
}

/// Gaps: every strength breaks at some speeds below its threshold and holds at some above it.
TEST(StrengthSearch, IsNotLedAstrayByGaps) {
    const Answer breaks = [](double critical, double speed) {
        const double share = speed / (0.5 * critical);
        if (share > 0.70 && share < 0.73) return true;
        if (share > 1.04 && share < 1.07) return false;
        return share >= 1;
    };
    for (const double guess : {4.0, 11.0, 12.4, 30.0})
        expectKept(searchStrength(breaks, 6, guess, 0.03), breaks, 6);
}

/// A weak body that happens to hold at 0.9 of the velocity alone is not the one that was asked for.
TEST(StrengthSearch, ALoneGapBelowIsNotAThreshold) {
    const Answer breaks = [](double critical, double speed) {
        if (critical < 9 && std::abs(speed / 5.4 - 1) < 0.01) return false;
        return speed >= 0.5 * critical;
    };
    const StrengthFound found = searchStrength(breaks, 6, 8, 0.03);
    expectKept(found, breaks, 6);
    EXPECT_NEAR(found.critical, 12, 1.2);
}

TEST(StrengthSearch, OfAThresholdThatJumpsAcrossTheMarginItBringsTheNearest) {
    // From 0.8 to 1.2 of 5 m/s at a strength of 10, and nothing between.
    const Answer breaks = [](double critical, double speed) {
        return speed >= (critical < 10 ? 0.40 : 0.60) * critical;
    };
    const StrengthFound found = searchStrength(breaks, 5, 7, 0.03);
    EXPECT_FALSE(found.met);
    EXPECT_NEAR(found.critical, 10, 0.3);
    EXPECT_NEAR(found.bracket.threshold(), 0.4 * found.critical, 0.07);
}

/// As a dropped wolf's: at a strength of 10 its threshold jumps from 0.8 to 1.2 of what is asked for, and
/// only farther from there than is looked around it comes back.
TEST(StrengthSearch, WhereThePromiseCannotBeKeptTheThresholdIs) {
    const double velocity = 5;
    const Answer breaks = [&](double critical, double speed) {
        const double share = critical < 10 ? 0.08 * critical : critical < 12 ? 1.2 : 0.96;
        return speed >= share * velocity;
    };
    for (const double guess : {6.0, 9.0, 10.5}) {
        const StrengthFound found = searchStrength(breaks, velocity, guess, 0.03);
        EXPECT_NEAR(found.bracket.threshold() / velocity, 0.96, 0.02) << guess;
        EXPECT_GE(found.critical, 12);
    }
}

TEST(StrengthSearch, SaysWhenNoStrengthDoesIt) {
    EXPECT_THROW(searchStrength([](double, double) { return true; }, 5, 5, 0.05), NumericalError);
    EXPECT_THROW(searchStrength([](double, double) { return false; }, 5, 5, 0.05), NumericalError);
    EXPECT_THROW(searchStrength(proportional(1), 5, 5, 0), UsageError);
    EXPECT_THROW(searchStrength(proportional(1), 195, 195, 0.05), UsageError);
}

}  // namespace
}  // namespace demolish
