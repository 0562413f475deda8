// SPDX-License-Identifier: Apache-2.0
// Wilson's interval against its closed form and published values, and counts from outcomes made by hand.
#include "app/breakage/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish::tests {
namespace {

TEST(Wilson, EndsSolveTheScoreEquation) {  // |p^ - p| = z sqrt(p (1 - p) / n)
    for (const uint32_t n : {1u, 4u, 30u, 300u})
        for (uint32_t hits = 0; hits <= n; hits += std::max(1u, n / 7)) {
            const Interval interval = wilsonInterval(hits, n, 1.5);
            const double share = double(hits) / n;
            for (const double end : {interval.low, interval.high})
                EXPECT_NEAR(std::fabs(share - end), 1.5 * std::sqrt(end * (1 - end) / n), 1e-12)
                    << hits << " of " << n;
            EXPECT_LE(interval.low, share);
            EXPECT_GE(interval.high, share);
        }
}

TEST(Wilson, KnownValues) {
    const Interval none = wilsonInterval(0, 30);  // high = z^2 / (n + z^2)
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 3.841458820694124 / 33.841458820694124, 1e-12);
    const Interval all = wilsonInterval(30, 30);
    EXPECT_EQ(all.high, 1);
    EXPECT_NEAR(all.low, 1 - none.high, 1e-12);
    const Interval half = wilsonInterval(15, 30);  // 1/2 -+ z / (2 sqrt(n + z^2))
    EXPECT_NEAR(half.low, 0.5 - 1.959963984540054 / (2 * std::sqrt(33.841458820694124)), 1e-12);
    EXPECT_NEAR(half.high, 1 - half.low, 1e-12);
    EXPECT_EQ(wilsonInterval(0, 0).low, 0);
    EXPECT_EQ(wilsonInterval(0, 0).high, 1);
}

/// Two packings, 30 / 40 / 50 m/s, a plan of one reading.
BreakagePlan smallPlan() {
    BreakagePlan plan;
    BreakageExperiment experiment;
    experiment.packings = 2;
    experiment.slowest = 30;
    experiment.fastest = 50;
    experiment.velocities = 3;
    plan.experiments = {experiment};
    return plan;
}

ItemResult resultOf(const BreakagePlan& plan) {
    ItemResult result;
    const auto runs = plan.items()[0];
    for (const BreakageRun& run : runs) {
        Outcome outcome;
        const bool weak = run.packing == 0 || run.size == 1;
        outcome.split = run.velocity > (weak ? 35 : 45);
        outcome.meridional = run.velocity > 45;
        outcome.children = outcome.split ? (run.velocity > 45 ? 9 : 3) : 1;
        result.outcomes.push_back(outcome);
    }
    result.impact_energy = 2;
    result.energy.kinetic = 1;
    result.energy.fracture = 1;
    return result;
}

TEST(Statistics, CountsByHand) {
    const BreakagePlan plan = smallPlan();
    const std::vector<ItemResult> results{resultOf(plan)};
    const BreakageStatistics statistics = summarise(plan, results)[0];
    const auto& small = statistics.cells[0];
    EXPECT_EQ(small[0].broken, 0u);
    EXPECT_EQ(small[1].broken, 1u);
    EXPECT_EQ(small[2].broken, 2u);
    EXPECT_EQ(small[1].specimens, 2u);
    EXPECT_EQ(small[1].children[3], 1u);
    EXPECT_EQ(small[2].children[kMostChildren], 2u);
    EXPECT_DOUBLE_EQ(small[2].meanChildren(), 9);
    EXPECT_DOUBLE_EQ(small[1].agreement(), 0.5);
    EXPECT_DOUBLE_EQ(small[2].agreement(), 1);
    EXPECT_EQ(statistics.cells[1][1].broken, 2u);
    EXPECT_DOUBLE_EQ(statistics.sum, 1);
    EXPECT_DOUBLE_EQ(shareOfThreeToFive(statistics, 0), 1.0 / 3);
}

TEST(Statistics, TheOtherRuleCountsOtherSpecimens) {
    BreakagePlan plan = smallPlan();
    plan.experiments[0].rule = BreakRule::kMeridional;
    const std::vector<ItemResult> results{resultOf(plan)};
    EXPECT_EQ(summarise(plan, results)[0].cells[1][1].broken, 0u);
}

TEST(Statistics, LinesBetweenVelocities) {
    const BreakagePlan plan = smallPlan();
    const std::vector<ItemResult> results{resultOf(plan)};
    const BreakageStatistics statistics = summarise(plan, results)[0];
    EXPECT_DOUBLE_EQ(probabilityAt(statistics, 0, 10), 0);
    EXPECT_DOUBLE_EQ(probabilityAt(statistics, 0, 35), 0.25);
    EXPECT_DOUBLE_EQ(probabilityAt(statistics, 0, 90), 1);
    EXPECT_DOUBLE_EQ(velocityAt(statistics, 0, 0.25), 35);
    EXPECT_DOUBLE_EQ(velocityAt(statistics, 1, 0.5), 35);
    const double miss[4] = {0.25, 0.25, 0.5 + 0.5 * 0.3 - 13.0 / 30, 1 - 16.0 / 30};
    double sum = 0;
    for (const double m : miss) sum += m * m;
    EXPECT_NEAR(distanceToPaper(statistics), std::sqrt(sum / 4), 1e-12);
}

TEST(Statistics, TheCountsOfFigureTwoAreOfThreeToFiveChildren) {
    const BreakagePlan plan = smallPlan();
    const std::vector<ItemResult> results{resultOf(plan)};
    const BreakageStatistics statistics = summarise(plan, results)[0];
    // At 40 m/s one of two small specimens and both large ones have 3 children; at 50 m/s all have 9.
    EXPECT_DOUBLE_EQ(countedAt(statistics, 0, 40), 0.5);
    EXPECT_DOUBLE_EQ(countedAt(statistics, 1, 40), 1);
    EXPECT_DOUBLE_EQ(countedAt(statistics, 1, 50), 0);
    const double miss[4] = {0.25, 0.25, 0.7 * 0.5 - 13.0 / 30, 0.7 - 16.0 / 30};
    double sum = 0;
    for (const double m : miss) sum += m * m;
    EXPECT_NEAR(distanceCounted(statistics), std::sqrt(sum / 4), 1e-12);
}

}  // namespace
}  // namespace demolish::tests
