// SPDX-License-Identifier: Apache-2.0
// When spheres and planes meet, against closed forms.
#include "sim_cuda/patterns/hard_touch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish {
namespace {

using Vec = Vec3<double>;
constexpr double kNever = 1e30;

TEST(HardTouch, SpheresOnStraightPaths) {
    EXPECT_NEAR(touchTime(Vec{3, 0, 0}, Vec{-10, 0, 0}, 1.0, 5.0), 0.2, 1e-12);
    // Off the line of centres by 0.6: they touch where the centres are 0.8 apart along the way.
    EXPECT_NEAR(touchTime(Vec{3, 0.6, 0}, Vec{-10, 0, 0}, 1.0, 5.0), 0.22, 1e-12);
    EXPECT_EQ(touchTime(Vec{3, 1.001, 0}, Vec{-10, 0, 0}, 1.0, 0.0), kNever) << "passes by";
    EXPECT_EQ(touchTime(Vec{3, 0, 0}, Vec{10, 0, 0}, 1.0, 0.0), kNever) << "flies away";
}

TEST(HardTouch, CountsWhatClosesFastEnoughWhereTheyTouch) {
    EXPECT_EQ(touchTime(Vec{3, 0, 0}, Vec{-10, 0, 0}, 1.0, 10.1), kNever);
    EXPECT_NEAR(touchTime(Vec{3, 0.6, 0}, Vec{-10, 0, 0}, 1.0, 7.9), 0.22, 1e-12);
    EXPECT_EQ(touchTime(Vec{3, 0.6, 0}, Vec{-10, 0, 0}, 1.0, 8.1), kNever) << "glances off";
    EXPECT_EQ(touchTime(Vec{0.9, 0, 0}, Vec{-10, 0, 0}, 1.0, 5.0), 0) << "overlaps already";
    EXPECT_EQ(touchTime(Vec{0.9, 0, 0}, Vec{-1, 0, 0}, 1.0, 5.0), kNever) << "lies on it";
}

TEST(HardTouch, PlanesWithGravity) {
    // 1 m at 4 m/s and 10 m/s^2: 4 t + 5 t^2 = 1, arriving at 6 m/s.
    const double t = (std::sqrt(36.0) - 4) / 10;
    EXPECT_NEAR(touchTime(1.0, 4.0, 10.0, 5.9), t, 1e-12);
    EXPECT_EQ(touchTime(1.0, 4.0, 10.0, 6.1), kNever);
    EXPECT_EQ(touchTime(-0.01, 4.0, 10.0, 3.0), 0);
    EXPECT_EQ(touchTime(1.0, -1.0, 10.0, 0.0), kNever) << "still on its way up";
}

TEST(HardTouch, WordsOfTimesKeepTheirOrder) {
    EXPECT_LT(wordOfTime(0.0), wordOfTime(1e-6));
    EXPECT_LT(wordOfTime(1e-3), wordOfTime(kNever));
}

}  // namespace
}  // namespace demolish
