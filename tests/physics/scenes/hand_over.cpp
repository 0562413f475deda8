// SPDX-License-Identifier: Apache-2.0
// Three runs of a scene side by side.
#include "tests/physics/scenes/hand_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

/// With `regimes`, hand-over and sleep.
Shot shotOf(const HandOverScene& scene, bool regimes, double faster) {
    Shot shot = smallScene(scene.name, scene.particles, scene.bodies);
    bringForward(shot, {.first = 0.05, .last = 0.35});
    shot.impact.velocity *= 1 + faster;
    shot.hand_over = shot.sleeping = regimes;
    return shot;
}

void print(bool regimes, const SceneOutcome& o) {
    std::printf(
        "%s: closure %.4f, damping %.3f, friction %.3f, fracture %.3f; %g bonds broken, %zu fragments, "
        "%g of 1 %%, largest %.3f; most rigid %u, asleep %u\n",
        regimes ? "handed over" : "bonds", o.closure, o.damping, o.friction, o.fracture, o.broken,
        o.masses.size(), o.big, o.largest, o.most_rigid, o.most_asleep);
}

std::vector<SceneOutcome> runsOf(const HandOverScene& scene, bool regimes) {
    std::vector<SceneOutcome> runs;
    for (int k = 0; k < scene.runs; ++k) {
        runs.push_back(outcomeOf(shotOf(scene, regimes, 1e-4 * k), scene.seconds));
        print(regimes, runs.back());
        EXPECT_GT(runs.back().closure, 0.995);
        EXPECT_LT(runs.back().closure, 1.05);
        EXPECT_EQ(runs.back().most_rigid > 10, regimes);
        EXPECT_EQ(runs.back().most_asleep > 0, regimes);
    }
    return runs;
}

/// Of everything; fragment k of the mean is the mean of the runs' k-th largest.
SceneOutcome meanOf(const std::vector<SceneOutcome>& runs) {
    SceneOutcome mean;
    const double share = 1 / static_cast<double>(runs.size());
    for (const SceneOutcome& run : runs) {
        mean.closure += share * run.closure;
        mean.damping += share * run.damping;
        mean.friction += share * run.friction;
        mean.fracture += share * run.fracture;
        mean.broken += share * run.broken;
        mean.big += share * run.big;
        mean.largest += share * run.largest;
        mean.masses.resize(std::max(mean.masses.size(), run.masses.size()));
        for (size_t k = 0; k < run.masses.size(); ++k) mean.masses[k] += share * run.masses[k];
    }
    return mean;
}

void expectAlike(const SceneOutcome& a, const SceneOutcome& b, const HandOverBounds& bounds) {
    EXPECT_NEAR(a.closure, b.closure, bounds.closure);
    EXPECT_NEAR(a.fracture, b.fracture, bounds.fracture);
    EXPECT_NEAR(a.damping + a.friction, b.damping + b.friction, bounds.damping_and_friction);
    EXPECT_NEAR(a.damping, b.damping, bounds.damping_or_friction);
    EXPECT_NEAR(a.friction, b.friction, bounds.damping_or_friction);
    EXPECT_NEAR(a.broken, b.broken, bounds.broken * a.broken);
    EXPECT_NEAR(a.big, b.big, 1 + bounds.big * a.big);
    EXPECT_NEAR(a.largest, b.largest, bounds.largest);
    EXPECT_LT(massDistance(a, b), bounds.masses);
}

}  // namespace

std::string nameOf(const HandOverScene& scene) {
    return scene.name;
}
void PrintTo(const HandOverScene& scene, std::ostream* out) {
    *out << scene.name;
}

void expectHandOverUnseen(const HandOverScene& scene, const HandOverBounds& bounds) {
    const std::vector<SceneOutcome> bonded = runsOf(scene, false), handed = runsOf(scene, true);
    const SceneOutcome mean = meanOf(bonded);
    EXPECT_GT(mean.broken, 100);
    for (const SceneOutcome& run : bonded) {
        std::printf("masses differ from the mean by %.3f\n", massDistance(mean, run));
        const testing::ScopedTrace trace(__FILE__, __LINE__,
                                         "a run with bonds alone, and the mean of all such");
        expectAlike(mean, run, bounds);
    }
    std::printf("means of masses differ by %.3f\n", massDistance(mean, meanOf(handed)));
    const testing::ScopedTrace trace(__FILE__, __LINE__, "without hand-over and sleep, and with them");
    expectAlike(mean, meanOf(handed), bounds);
}

void expectMomentumKept(const HandOverScene& scene) {
    for (const bool hand_over : {false, true}) {
        Shot shot = smallScene(scene.name, scene.particles, scene.bodies);
        shot.hand_over = hand_over;
        shot.sleeping = false;  // what sleeps is stopped: there is no floor here that could take up the rest
        const Straying straying = strayingOf(shot, 0.03, 40);
        std::printf("momentum strays by %.1e, angular momentum by %.1e; most rigid %u\n", straying.linear,
                    straying.angular, straying.most_rigid);
        EXPECT_GT(straying.broken, 80u);
        EXPECT_EQ(straying.most_rigid > 2, hand_over);
        EXPECT_LT(straying.linear, 2e-6);
        EXPECT_LT(straying.angular, 2e-6);
    }
}

}  // namespace demolish::tests
