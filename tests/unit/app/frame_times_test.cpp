// SPDX-License-Identifier: Apache-2.0
// What the FPS numbers mean.
#include "app/session/frame_times.h"

#include <gtest/gtest.h>

namespace demolish {
namespace {

TEST(FrameTimes, QuantilesInterpolate) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({1, 2, 3}, 0), 1);
    EXPECT_DOUBLE_EQ(quantile({1, 2, 3}, 1), 3);
    EXPECT_DOUBLE_EQ(quantile({10, 20}, 0.25), 12.5);
    EXPECT_DOUBLE_EQ(quantile({7}, 0.99), 7);
    EXPECT_DOUBLE_EQ(quantile({}, 0.5), 0);
}

TEST(FrameTimes, LowFpsIsTheSlowEndOfFrameTimes) {
    std::vector<FrameSample> samples(99, {10, 6, 3});
    samples.push_back({110, 100, 3});
    const FrameSummary summary = summarise(samples);
    EXPECT_DOUBLE_EQ(summary.fps_median, 100);
    EXPECT_NEAR(summary.frame_ms_p99, 11, 1e-9);  // a hundredth of the way from 10 to 110
    EXPECT_NEAR(summary.fps_p1, 1000.0 / 11, 1e-9);
    EXPECT_GE(summary.fps_p99, summary.fps_median);
    EXPECT_LT(summary.fps_p1, summary.fps_median);
    EXPECT_DOUBLE_EQ(summary.sim_ms, 6);
    EXPECT_DOUBLE_EQ(summary.draw_ms, 3);
}

TEST(FrameTimes, NoFramesGiveZeroAndNotInfinity) {
    const FrameSummary summary = summarise({});
    EXPECT_EQ(summary.fps_median, 0);
    EXPECT_EQ(summary.fps_p1, 0);
}

/// A frame that ends at `time`; ms of the whole and of its stages.
FrameSample frameAt(double time, double frame_ms, double sim_ms = 0, double transfer_ms = 0,
                    double draw_ms = 0) {
    FrameSample sample{frame_ms, sim_ms, draw_ms, transfer_ms};
    sample.stats.time = time;
    return sample;
}

TEST(FrameTimes, TheStagesAndTheRestAreTheWholeFrame) {
    EXPECT_DOUBLE_EQ(frameAt(0, 10, 5, 1, 3).restMs(), 1);
    EXPECT_DOUBLE_EQ(frameAt(0, 10, 5, 1, 6).restMs(), 0) << "a GPU timer may say more than the wall clock";
    const std::vector<FrameSample> samples{frameAt(0, 10, 5, 1, 3), frameAt(1, 20, 7, 2, 3),
                                           frameAt(2, 30, 9, 3, 3)};
    const FrameSummary summary = summarise(samples);
    EXPECT_EQ(summary.frames, 3u);
    EXPECT_DOUBLE_EQ(summary.frame_ms_median, 20);
    EXPECT_DOUBLE_EQ(summary.frame_ms_worst, 30);
    EXPECT_DOUBLE_EQ(summary.sim_ms, 7);
    EXPECT_DOUBLE_EQ(summary.transfer_ms, 2);
    EXPECT_DOUBLE_EQ(summary.draw_ms, 3);
    EXPECT_DOUBLE_EQ(summary.rest_ms, 8);
}

TEST(FrameTimes, CountsAreMediansOfWhatIsAwakeAndTheMostOfWhatThereIs) {
    std::vector<FrameSample> samples(3);
    for (uint32_t i = 0; i < 3; ++i) {
        FrameStats& stats = samples[i].stats;
        stats.particles = 100;
        stats.awake_particles = 10 * i;
        stats.bonded_particles = 5 * i;
        stats.awake_bodies = i;
        stats.substeps = 200 + i;
        stats.fragments = 7 - i;
        stats.rigid_fragments = i;
        stats.sleeping_fragments = 3 * i;
        samples[i].triangles = 1000 * i;
    }
    const FrameSummary summary = summarise(samples);
    EXPECT_EQ(summary.particles, 100u);
    EXPECT_EQ(summary.awake_particles, 10);
    EXPECT_EQ(summary.bonded_particles, 5);
    EXPECT_EQ(summary.awake_bodies, 1);
    EXPECT_EQ(summary.substeps, 201);
    EXPECT_EQ(summary.fragments, 7u);
    EXPECT_EQ(summary.rigid_fragments, 2u);
    EXPECT_EQ(summary.sleeping_fragments, 6u);
    EXPECT_EQ(summary.triangles, 2000u);
}

/// Ten frames of 1/60 s: 1 ms while whole, 100 ms when bonds break, 5 ms after.
std::vector<FrameSample> breakingShot() {
    std::vector<FrameSample> samples;
    double time = 0;
    for (int frame = 0; frame < 10; ++frame) {
        time += 1.0 / 60;
        samples.push_back(frameAt(time, frame < 4 ? 1 : frame == 4 ? 100 : 5));
        samples.back().stats.fracture_changed = frame == 4;
    }
    return samples;
}

TEST(FrameTimes, EveryFrameBelongsToThePhaseInWhichItEnds) {
    const std::vector<Phase> phases{{"whole", 0, 4.0 / 60, 280}, {"all broken", 4.0 / 60, 10.0 / 60, 155}};
    const auto rows = summarisePhases(breakingShot(), phases);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0].phase.name, "whole");
    EXPECT_EQ(rows[0].times.frames, 4u) << "a sum of sixtieths must not fall beside the border";
    EXPECT_DOUBLE_EQ(rows[0].times.fps_median, 1000);
    EXPECT_DOUBLE_EQ(rows[0].ratio(), 1000.0 / 280);
    EXPECT_EQ(rows[1].times.frames, 6u);
    EXPECT_DOUBLE_EQ(rows[1].times.frame_ms_median, 5);
    EXPECT_DOUBLE_EQ(rows[1].times.frame_ms_worst, 100);
    EXPECT_DOUBLE_EQ(rows[1].ratio(), 200.0 / 155);
}

TEST(FrameTimes, TheFramesInWhichBondsBreakHaveARowOfTheirOwn) {
    const auto rows = summarisePhases(breakingShot(), {});
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1].phase.name, kBreakingRow);
    EXPECT_EQ(rows[1].times.frames, 1u);
    EXPECT_DOUBLE_EQ(rows[1].times.frame_ms_median, 100);
    EXPECT_EQ(rows[1].ratio(), 0) << "the paper has no number for it";
    EXPECT_EQ(rows[2].phase.name, kAllFramesRow);
    EXPECT_EQ(rows[2].times.frames, 10u);
}

TEST(FrameTimes, WhileItBreaksIsFromTheFirstBreakToTheLast) {
    auto samples = breakingShot();
    samples[7].stats.fracture_changed = true;
    const auto rows = summarisePhases(samples, {});
    EXPECT_EQ(rows[0].phase.name, kWhileItBreaksRow);
    EXPECT_EQ(rows[0].times.frames, 4u) << "those between two breaks too";
    EXPECT_DOUBLE_EQ(rows[0].times.fps_mean, 4 / 0.115) << "over all their time, the slow one's too";
    EXPECT_DOUBLE_EQ(rows[0].phase.from, samples[4].stats.time);
    EXPECT_DOUBLE_EQ(rows[0].phase.to, samples[7].stats.time);
    samples[4].stats.fracture_changed = samples[7].stats.fracture_changed = false;
    EXPECT_EQ(summarisePhases(samples, {})[0].times.frames, 0u);
}

TEST(FrameTimes, APhaseWithoutFramesHasNoSpeed) {
    const std::vector<Phase> phases{{"late", 5, 6, 40}};
    const auto rows = summarisePhases(breakingShot(), phases);
    EXPECT_EQ(rows[0].times.frames, 0u);
    EXPECT_EQ(rows[0].times.fps_median, 0);
    EXPECT_EQ(rows[0].ratio(), 0);
    EXPECT_EQ(phaseAt(phases, 5.5), &phases[0]);
    EXPECT_EQ(phaseAt(phases, 5), nullptr);
    EXPECT_EQ(phaseAt(phases, 6), &phases[0]);
}

TEST(FrameTimes, FramesWithoutAStepAreNoSimulation) {
    const std::vector<FrameSample> samples{frameAt(1, 2, 0), frameAt(1, 20, 15), frameAt(1, 2, 0)};
    const auto simulated = simulatedFrames(samples);
    ASSERT_EQ(simulated.size(), 1u);
    EXPECT_DOUBLE_EQ(summarise(simulated).fps_median, 50);
}

TEST(FrameTimes, HistoryKeepsTheLatest) {
    FrameHistory history(3);
    for (int i = 1; i <= 5; ++i) history.add({static_cast<double>(i), 0, 0});
    ASSERT_EQ(history.samples().size(), 3u);
    EXPECT_EQ(history.samples().front().frame_ms, 3);
    EXPECT_EQ(history.samples().back().frame_ms, 5);
}

}  // namespace
}  // namespace demolish
