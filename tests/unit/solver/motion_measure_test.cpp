// SPDX-License-Identifier: Apache-2.0
// How fast a fragment counts as moving when it is asked whether it rests.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "sim_cuda/kernels/calm_clocks.h"

namespace demolish::tests {
namespace {

/// Two cells of one fragment, and looks at them.
class TwoCells {
  public:
    Vec4<float> position[2] = {{1, 2, 3, 0}, {1.2f, 2, 3, 0}}, velocity[2] = {}, spin[2] = {},
                rotation[2] = {{0, 0, 0, 1}, {0, 0, 0, 1}};

    /// m/s, `passed` s after the last look.
    double look(double passed) {
        uint32_t fastest[2] = {0, 0};
        const StateIn<float> state{{position, 2}, {rotation, 2}, {velocity, 2}, {spin, 2}};
        const MeasureMotion<float> measure{state,        {constants_, 2}, {label_, 2},
                                           {former_, 2}, {fastest, 2},    passed};
        measure(0);
        measure(1);
        EXPECT_EQ(fastest[1], 0u) << "of the slot alone";
        return std::sqrt(double(std::bit_cast<float>(fastest[0])));
    }

  private:
    ParticleConstants<float> constants_[2] = {{1, 1, 0.1f, 0.1f}, {1, 1, 0.1f, 0.1f}};
    uint32_t label_[2] = {0, 0};
    FormerPose former_[2];
};

constexpr double kFrame = 1.0 / 60;

TEST(MeasureMotion, TheFirstLookKnowsVelocitiesAlone) {
    TwoCells cells;
    cells.velocity[1] = {0, 5, 0, 0};
    EXPECT_NEAR(cells.look(0), 5, 1e-6);
    TwoCells later;
    later.velocity[1] = {0, 5, 0, 0};
    EXPECT_NEAR(later.look(kFrame), 5, 1e-6) << "what is fired stands nowhere before";
}
/// A crumb between others that is thrown to and fro in each contact step.
TEST(MeasureMotion, WhatSwingsAboutItsPlaceRests) {
    TwoCells cells;
    cells.look(0);
    for (int frame = 0; frame < 3; ++frame) {
        cells.velocity[0] = {0.5f, 0, 0, 0};
        cells.spin[1] = {0, 0, frame % 2 == 0 ? 4.0f : -4.0f, 0};
        EXPECT_LT(cells.look(kFrame), 1e-3);
    }
}
TEST(MeasureMotion, WhatComesFarAndIsFastMovesAsTheSlowerOfTheTwoSays) {
    TwoCells cells;
    cells.look(0);
    cells.velocity[0] = {0.5f, 0, 0, 0};
    cells.position[0].x += 0.3f / 60;
    EXPECT_NEAR(cells.look(kFrame), 0.3, 1e-4);
    cells.position[0].x += 0.7f / 60;
    EXPECT_NEAR(cells.look(kFrame), 0.5, 1e-4);
}
/// A single cell that turns on the spot.
TEST(MeasureMotion, ATurnCountsWithTheRadius) {
    TwoCells cells;
    cells.look(0);
    const double spin = 2;  // rad/s
    cells.spin[1] = {0, float(spin), 0, 0};
    cells.rotation[1] = {0, float(std::sin(0.5 * spin * kFrame)), 0, float(std::cos(0.5 * spin * kFrame))};
    EXPECT_NEAR(cells.look(kFrame), spin * 0.1, 1e-4);
}
/// Decisions within a frame measure no way, and the next one is that of the whole frame.
TEST(MeasureMotion, ALookInBetweenForgetsNothing) {
    TwoCells cells;
    cells.look(0);
    cells.velocity[0] = {1, 0, 0, 0};
    cells.position[0].x += 0.2f / 60;
    EXPECT_NEAR(cells.look(0), 1, 1e-6);
    cells.position[0].x += 0.2f / 60;
    EXPECT_NEAR(cells.look(kFrame), 0.4, 1e-4);
}

}  // namespace
}  // namespace demolish::tests
