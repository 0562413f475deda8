// SPDX-License-Identifier: Apache-2.0
// What counts as broken, on cuts known beforehand.
#include "app/breakage/outcome.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim_cuda/api/sphere_specimen.h"

namespace demolish::tests {
namespace {

const BreakableBody& specimen() {
    static const auto kBody = packSphereSpecimen({.grains = 400, .seed = 4});
    return *kBody;
}

/// Labels by a rule on the grain's place, lengths over the radius.
template <class Rule>
std::vector<uint32_t> cut(Rule rule) {
    std::vector<uint32_t> labels;
    for (const Particle& grain : specimen().particles)
        labels.push_back(rule(grain.seed.x / 12e-6, grain.seed.y / 12e-6, grain.seed.z / 12e-6));
    return labels;
}

TEST(Outcome, AWholeSpecimenIsNotBroken) {
    const Outcome outcome = judge(specimen(), cut([](double, double, double) { return 7u; }));
    EXPECT_EQ(outcome.children, 1u);
    EXPECT_DOUBLE_EQ(outcome.largest, 1);
    EXPECT_FALSE(outcome.split);
    EXPECT_FALSE(outcome.meridional);
}

TEST(Outcome, HalvesAlongTheLineOfImpactAreBrokenByBothRules) {
    const Outcome outcome = judge(specimen(), cut([](double x, double, double) { return x > 0 ? 1u : 2u; }));
    EXPECT_EQ(outcome.children, 2u);
    EXPECT_NEAR(outcome.largest, 0.5, 0.05);
    EXPECT_TRUE(outcome.split);
    EXPECT_TRUE(outcome.meridional);
}

TEST(Outcome, HalvesAcrossTheLineOfImpactHaveNoCrackAlongIt) {
    const Outcome outcome = judge(specimen(), cut([](double, double y, double) { return y > 0 ? 1u : 2u; }));
    EXPECT_TRUE(outcome.split);
    EXPECT_FALSE(outcome.meridional);
}

TEST(Outcome, ACrackThatStopsHalfWayDoesNotCount) {
    const auto labels = cut([](double x, double y, double) { return y > 0 ? 1u : x > 0 ? 1u : 2u; });
    const Outcome outcome = judge(specimen(), labels);
    EXPECT_EQ(outcome.children, 2u);
    EXPECT_TRUE(outcome.split) << outcome.largest;
    EXPECT_FALSE(outcome.meridional);
}

TEST(Outcome, CrumbsInTheCrackBelongToTheChildrenBesideThem) {
    uint32_t next = 100;
    const auto labels = cut([&](double x, double, double) {
        return x > 0.12 ? 1u : x < -0.12 ? 2u : next++;  // a wide crack full of single grains
    });
    const Outcome outcome = judge(specimen(), labels);
    EXPECT_EQ(outcome.children, 2u);
    EXPECT_TRUE(outcome.meridional);
}

TEST(Outcome, CrumbsAloneMakeNoCrack) {
    uint32_t next = 100;
    const auto labels = cut([&](double x, double y, double) { return y < -0.7 && x > 0 ? next++ : 1u; });
    const Outcome outcome = judge(specimen(), labels);
    EXPECT_EQ(outcome.children, 1u);
    EXPECT_FALSE(outcome.meridional);
}

TEST(Outcome, TwoCracksThatDoNotMeetAreNoCrackThrough) {
    // A chip from the top and one from the bottom reach every slab between them, but not as one crack.
    const auto labels = cut([](double x, double y, double) {
        if (x > 0.35 && y > 0.02) return 2u;
        if (x < -0.35 && y < -0.02) return 3u;
        return 1u;
    });
    const Outcome outcome = judge(specimen(), labels);
    EXPECT_EQ(outcome.children, 3u);
    EXPECT_FALSE(outcome.meridional);
}

TEST(Outcome, EachRuleLooksAtItsOwnSign) {
    Outcome two{.largest = 0.5, .children = 2, .split = true, .meridional = false};
    EXPECT_TRUE(isBroken(two, BreakRule::kLargest, {}));
    EXPECT_FALSE(isBroken(two, BreakRule::kMeridional, {}));
    EXPECT_FALSE(isBroken(two, BreakRule::kFlaps, {}));
    EXPECT_TRUE(isBroken(two, BreakRule::kFlaps, {.flaps = 2}));
}

TEST(Outcome, ChildrenAreCountedByVolume) {
    const auto labels = cut([](double x, double y, double) { return y < -0.5 ? 2u : x > 0.8 ? 3u : 1u; });
    double volume[4] = {}, whole = 0;
    for (size_t i = 0; i < labels.size(); ++i) {
        whole += specimen().particles[i].volume;
        volume[labels[i]] += specimen().particles[i].volume;
    }
    ASSERT_GT(volume[2], 0.03 * whole);
    ASSERT_LT(volume[3], 0.03 * whole);
    const Outcome outcome = judge(specimen(), labels);
    EXPECT_EQ(outcome.children, 2u);
    EXPECT_NEAR(outcome.largest, volume[1] / whole, 1e-12);
    EXPECT_EQ(judge(specimen(), labels, {.child_share = 0.99 * volume[3] / whole}).children, 3u);
}

}  // namespace
}  // namespace demolish::tests
