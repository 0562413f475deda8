// SPDX-License-Identifier: Apache-2.0
// What a shot will take: counted as the solver counts, said with its knobs. Times are not judged here: see
// docs/measurements/cost_of_a_shot.md.
#include "app/session/shot_cost.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/commands/shot_options.h"
#include "app/session/built_shot.h"

namespace demolish {
namespace {

ShotOptions few(const std::string& scene) {
    ShotOptions options;
    options.scene = scene;
    options.device = "cpu";
    options.particles = 40;
    return options;
}

/// Of the four scenes and odd shots of them.
std::vector<ShotOptions> shots() {
    std::vector<ShotOptions> all = {few("bunny"), few("wolf"), few("vase"), few("column"), few("block")};
    all[3].height = 0.3;
    all[3].fps = 25;
    all[3].material = "glass";
    for (const double fps : {1.0, 24.0, 59.94, 1000.0}) {
        all.push_back(few("block"));
        all.back().fps = fps;
        all.back().substeps = 61;
        all.back().slow_motion = 0.3;
    }
    all.push_back(few("block"));
    all.back().drop = 8.46;
    for (const std::string& method : methodNames()) {
        all.push_back(few("block"));
        all.back().method = method;
    }
    return all;
}

TEST(ShotCost, CountsTheSubstepsThatTheSolverTakes) {
    for (const ShotOptions& options : shots()) {
        Shot shot = makeShot(options);
        shot.settle_time = std::min(shot.settle_time, 0.01);
        BuiltShot built = prepareShot(shot, {.draw_geometry = false}, {});
        const ShotWork work = workOf(built.shot, built.setup);
        makeSolver(built, {});
        ASSERT_EQ(built.solver->advanceFrame(shot.time_scale), StepStatus::kOk);
        const FrameStats& stats = built.solver->stats();
        EXPECT_EQ(work.substeps, stats.substeps) << options.scene;
        EXPECT_DOUBLE_EQ(work.time_step, stats.time_step);
        EXPECT_EQ(work.particles, stats.particles);
        EXPECT_EQ(work.bonds, stats.bonds);
        EXPECT_EQ(work.bodies, built.setup.bodies.size());
    }
}

TEST(ShotCost, IsSubstepsTimesTheirTime) {
    ShotWork work;
    work.particles = 1000;
    work.substeps = 500;
    work.settle_substeps = 20000;
    const ShotCost cost = costOf(work, {{1e-6, 1e-7}, {2e-6, 2e-7}});
    EXPECT_NEAR(cost.whole_frame_ms, 1000 * 500 * 101e-6, 1e-9);
    EXPECT_NEAR(cost.breaking_frame_ms, 1000 * 500 * 202e-6, 1e-9);
    EXPECT_NEAR(cost.settle_seconds, 20000 * 101e-6, 1e-9);
}

TEST(ShotCost, BondsThatNobodyStepsAreNotPriced) {
    for (const std::string& method : methodNames()) {
        ShotOptions options = few("block");
        options.method = method;
        const BuiltShot built = prepareShot(makeShot(options), {.draw_geometry = false}, {});
        ShotWork work = workOf(built.shot, built.setup);
        const bool preset = method.starts_with("pattern");
        EXPECT_EQ(work.steps_bonds, !preset) << method;
        work.substeps = 100'000;  // slow, if they were taken
        const ShotCost cost = costOf(work, {{1e-6, 1e-5}, {2e-6, 2e-5}});
        EXPECT_EQ(cost.breaking_frame_ms == 0 && cost.whole_frame_ms == 0, preset) << method;
        EXPECT_EQ(mayBeSlow(work, false), !preset) << method;
        EXPECT_EQ(slowNote(work, cost).empty(), preset) << method;
        EXPECT_TRUE(!preset || work.settle_substeps == 0) << method;
    }
}

TEST(ShotCost, ASlowShotIsSaidWithItsKnobs) {
    ShotWork work;
    work.particles = 4000;
    work.substeps = 5837;
    work.time_step = 1.0 / 60 / 2432;
    EXPECT_EQ(slowNote(work, {9, 100, 900}), "");
    using testing::HasSubstr;
    const std::string frames = slowNote(work, {9, 1200, 2600});
    for (const char* part :
         {"5837 substeps", "2.6 s a frame", "--particles", "--substeps", "now 2432", "--height"})
        EXPECT_THAT(frames, HasSubstr(part));
    EXPECT_THAT(frames, testing::Not(HasSubstr("settled")));
    EXPECT_THAT(slowNote(work, {34, 1200, 2600}), HasSubstr("about 34 s until its bodies have settled"));
}

TEST(ShotCost, WhatCannotBeSlowIsNotMeasured) {
    ShotWork work;
    work.particles = 1200;
    work.substeps = 300;
    work.settle_substeps = 6000;
    EXPECT_FALSE(mayBeSlow(work, false));
    work.settle_substeps = 60000;
    EXPECT_TRUE(mayBeSlow(work, false)) << "settling";
    EXPECT_FALSE(mayBeSlow(work, true));
    work.settle_substeps = 0;
    work.substeps = 3000;
    EXPECT_TRUE(mayBeSlow(work, false)) << "frames";
}

TEST(ShotCost, ThePaceOfThisMachineIsMeasured) {
    const DevicePace pace = measurePace(false, 1000);
    for (const SubstepTime& time : {pace.whole, pace.breaking}) {
        EXPECT_GE(time.fixed, 0);
        EXPECT_GT(time.each, 0);
        EXPECT_LT(time.of(1000), 1) << "s";
    }
}

TEST(ShotCost, SettlingTakesAsLongAsFalling) {
    ShotOptions options = few("column");
    const Shot own = makeShot(options);
    EXPECT_EQ(own.settle_scale, 1);
    options.height = own.height / 25;
    const Shot small = makeShot(options);
    EXPECT_DOUBLE_EQ(small.settle_scale, 0.2);
    const BuiltShot built = prepareShot(small, {.draw_geometry = false}, {});
    EXPECT_DOUBLE_EQ(built.setup.params.settle_time, 0.2 * own.settle_time);
    EXPECT_DOUBLE_EQ(built.setup.params.settle_damping, 5 * SolverParams{}.settle_damping);
    EXPECT_EQ(workOf(small, built.setup).settle_substeps,
              static_cast<uint64_t>(
                  std::ceil(built.setup.params.settle_time / workOf(small, built.setup).time_step)));
}

TEST(ShotCost, TimesAreShownInTheirUnit) {
    EXPECT_EQ(shownTime(0), "0.0 s");
    EXPECT_EQ(shownTime(0.0000042), "4.2 us");
    EXPECT_EQ(shownTime(0.0042), "4.2 ms");
    EXPECT_EQ(shownTime(0.13), "130 ms");
    EXPECT_EQ(shownTime(2.44), "2.4 s");
    EXPECT_EQ(shownTime(160), "160 s");
}

}  // namespace
}  // namespace demolish
