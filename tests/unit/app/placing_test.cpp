// SPDX-License-Identifier: Apache-2.0
// Rays that meet bodies, and where a body comes to stand.
#include "app/session/placing.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/app/grid_cube.h"

namespace demolish {
namespace {

/// Cubes of 1 m: one at the origin, one at x = 3 turned by an eighth.
class Placing : public testing::Test {
  protected:
    Placing() {
        shot_.height = 2;  // places are in heights
        shot_.bodies.resize(2);
        shot_.bodies[1].position = {1.5, 0, 0};
        shot_.bodies[1].yaw = std::numbers::pi / 4;
    }
    Shot shot_;
    BodyList bodies_ = BodyList(2, std::make_shared<const BreakableBody>(test::gridCube(10)));
};

TEST_F(Placing, ARayMeetsWhatComesFirst) {
    const auto along_x = [&](float y) { return engine::Ray{{-4, y, 0.05f}, {1, 0, 0}}; };
    const auto first = whatRayMeets(shot_, bodies_, along_x(0.5f));
    ASSERT_TRUE(first && first->body);
    EXPECT_EQ(*first->body, 0u);
    EXPECT_NEAR(first->point.x, -0.5, 0.06);
    const auto behind = whatRayMeets(shot_, bodies_, along_x(0.5f), 0);
    ASSERT_TRUE(behind && behind->body);
    EXPECT_EQ(*behind->body, 1u);
    EXPECT_NEAR(behind->point.x, 3 - std::sqrt(0.5), 0.15) << "the edge of a turned cube";
    EXPECT_FALSE(whatRayMeets(shot_, bodies_, along_x(1.5f))) << "above them all";
    shot_.bodies[0].hidden = true;
    EXPECT_EQ(whatRayMeets(shot_, bodies_, along_x(0.5f))->body, 1u) << "what is not seen is not met";
    const auto floor = whatRayMeets(shot_, bodies_, {{8, 1, 0}, {0, -1, 0}});
    ASSERT_TRUE(floor);
    EXPECT_FALSE(floor->body);
    EXPECT_NEAR(floor->point.y, 0, 1e-3);
}

TEST_F(Placing, ABodyStandsOnWhatLiesBelow) {
    EXPECT_NEAR(restingHeight(shot_, bodies_, 0, -5, 0, 9), 0, 1e-3) << "the floor";
    EXPECT_NEAR(restingHeight(shot_, bodies_, 0, 3, 0, 9), 1, 1e-6) << "the other cube";
    EXPECT_NEAR(restingHeight(shot_, bodies_, 0, 3.9, 0, 9), 1, 1e-6) << "its edge";
    EXPECT_NEAR(restingHeight(shot_, bodies_, 0, 5, 0, 9), 0, 1e-3);
    Collider step = Box{{1, 0.25, 1}, {-2.5, 0.125, 0}, {}};
    shot_.colliders = {step};  // of the double length in this shot
    EXPECT_NEAR(restingHeight(shot_, bodies_, 0, -5, 0, 9), 0.5, 1e-3);
}

}  // namespace
}  // namespace demolish
