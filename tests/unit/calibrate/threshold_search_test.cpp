// SPDX-License-Identifier: Apache-2.0
// The bisection by itself, on bodies that break at a known speed.
#include <gtest/gtest.h>

#include "app/calibrate/threshold_search.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

TEST(ThresholdSearch, FindsTheSpeedFromAnyGuessWithinTheTolerance) {
    for (const double truth : {0.02, 1.0, 7.3, 150.0})
        for (const double guess : {0.001, 0.5, 7.3, 190.0}) {
            const Bracket found = searchThreshold([&](double speed) { return speed >= truth; }, guess, 0.03);
            EXPECT_LT(found.holds, truth);
            EXPECT_GE(found.breaks, truth);
            EXPECT_LE(found.breaks / found.holds, 1.03);
            EXPECT_NEAR(found.threshold() / truth, 1, 0.031);
        }
}

TEST(ThresholdSearch, AGoodGuessTakesFewTrials) {
    uint32_t trials = 0;
    const Bracket found = searchThreshold(
        [&](double speed) {
            ++trials;
            return speed >= 5;
        },
        4.6, 0.05);
    EXPECT_EQ(found.trials, trials);
    EXPECT_LE(trials, 9u);
}

TEST(ThresholdSearch, FindsTheSpeedFromWhichOnTheBodyBreaks) {
    // Breaks from 3 on, holds again between 4 and 5 (a hole is punched), breaks from 5 on.
    const auto breaks = [](double speed) { return speed >= 5 || (speed >= 3 && speed < 4); };
    for (const double guess : {0.5, 2.9, 3.5, 6.0, 40.0}) {
        const Bracket found = searchThreshold(breaks, guess, 0.03);
        EXPECT_LT(found.holds, 5) << guess;
        EXPECT_GE(found.breaks, 5) << guess;
        EXPECT_NEAR(found.threshold() / 5, 1, 0.031) << guess;
    }
}

TEST(ThresholdSearch, SaysWhenThereIsNoThreshold) {
    EXPECT_THROW(searchThreshold([](double) { return true; }, 5, 0.05), NumericalError);
    EXPECT_THROW(searchThreshold([](double) { return false; }, 5, 0.05), NumericalError);
    EXPECT_THROW(searchThreshold([](double) { return true; }, 5, 0), UsageError);
}

TEST(ThresholdSearch, TheEndsOfTheRangeAreTried) {
    const auto tried = [](double truth, double guess) {
        return searchThreshold([&](double speed) { return speed >= truth; }, guess, 0.05);
    };
    EXPECT_EQ(tried(kThresholdRange.most, 180).breaks, kThresholdRange.most);
    EXPECT_GT(tried(0.0101, 0.012).holds, 0);
}

}  // namespace
}  // namespace demolish
