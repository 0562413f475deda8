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

TEST(FrameTimes, HistoryKeepsTheLatest) {
    FrameHistory history(3);
    for (int i = 1; i <= 5; ++i) history.add({static_cast<double>(i), 0, 0});
    ASSERT_EQ(history.samples().size(), 3u);
    EXPECT_EQ(history.samples().front().frame_ms, 3);
    EXPECT_EQ(history.samples().back().frame_ms, 5);
}

}  // namespace
}  // namespace demolish
