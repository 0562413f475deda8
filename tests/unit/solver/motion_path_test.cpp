// SPDX-License-Identifier: Apache-2.0
// Where paths lead between their keys.
#include "sim_cuda/solver/motion_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish::tests {
namespace {

MotionPath thereAndOn(bool smooth) {
    return {{{1, {1, 0, 0}, {}}, {2, {1, 0, 0}, {}}, {4, {5, 0, 0}, {0, 0, 2 * M_PI}}}, smooth};
}

TEST(MotionPath, PassesThroughItsKeysAndStaysAtTheLast) {
    for (const bool smooth : {false, true}) {
        const MotionPath path = thereAndOn(smooth);
        EXPECT_EQ(poseAt(path, 0).way.x, 0);
        for (const PathKey& key : path.keys) EXPECT_NEAR(poseAt(path, key.time).way.x, key.way.x, 1e-12);
        EXPECT_EQ(poseAt(path, 9).way.x, 5);
        EXPECT_NEAR(std::abs(poseAt(path, 9).turned.w), 1, 1e-12) << "a whole turn";
        EXPECT_NEAR(poseAt(path, 3).turned.z, 1, 1e-12) << "half of it";
    }
}

TEST(MotionPath, ALinearOneKeepsItsSpeedBetweenKeys) {
    const MotionPath path = thereAndOn(false);
    EXPECT_NEAR(poseAt(path, 0.3).way.x, 0.3, 1e-12);
    EXPECT_NEAR(poseAt(path, 2.5).way.x, 2, 1e-12);
}

TEST(MotionPath, ASmoothOneHasNoJumpOfSpeedAndOvershootsNoKey) {
    const MotionPath path{{{1, {1, 0, 0}, {}}, {2, {3, 0, 0}, {}}, {3, {3, 0, 0}, {}}, {4, {2, 0, 0}, {}}},
                          true};
    constexpr double kStep = 1e-4;
    double former = 0, largest = 0;
    for (double time = 0; time < 4.5; time += kStep) {
        const double x = poseAt(path, time).way.x, speed = (poseAt(path, time + kStep).way.x - x) / kStep;
        EXPECT_LE(std::abs(speed - former), 12 * kStep) << time;
        former = speed;
        largest = std::max(largest, x);
    }
    EXPECT_LE(largest, 3 + 1e-9);
    // The harmonic mean of the slopes 1 and 2.
    EXPECT_NEAR((poseAt(path, 1 + kStep).way.x - poseAt(path, 1 - kStep).way.x) / (2 * kStep), 4.0 / 3, 1e-3);
}

TEST(MotionPath, TakesPointsAlongAboutItsPivot) {
    const MotionPath path{{{2, {4, 0, 0}, {0, 0, M_PI}}}, false};
    const Double3 start = placeOnPath(path, {1, 1, 0}, {1, 2, 3}, 0),
                  half = placeOnPath(path, {1, 1, 0}, {1, 2, 3}, 1);
    EXPECT_EQ(start, (Double3{1, 2, 3}));
    EXPECT_NEAR(half.x, 1 + 2 - 1, 1e-12) << "2 m on, a quarter turned";
    EXPECT_NEAR(half.y, 1, 1e-12);
    EXPECT_NEAR(half.z, 3, 1e-12);
}

TEST(MotionPath, KnowsWhenItMoves) {
    const MotionPath path = thereAndOn(true);
    EXPECT_TRUE(movesBetween(path, 0.9, 1.1));
    EXPECT_FALSE(movesBetween(path, 1.1, 1.9));
    EXPECT_FALSE(movesBetween(path, 1.1, 2));
    EXPECT_TRUE(movesBetween(path, 1.1, 2.01));
    EXPECT_FALSE(movesBetween(path, 4, 9));
    EXPECT_FALSE(movesBetween(MotionPath{}, 0, 9));
}

TEST(MotionPath, TurnsAreSeenTheShorterWay) {
    const Quat<double> from{0, 0, 0, 1}, to{0, 0, std::sin(0.3), std::cos(0.3)};
    EXPECT_NEAR(turnBetween(from, to).z, 0.6, 1e-12);
    EXPECT_NEAR(turnBetween(from, {0, 0, -to.z, -to.w}).z, 0.6, 1e-12);
    EXPECT_EQ(turnBetween(to, to).z, 0);
}

}  // namespace
}  // namespace demolish::tests
