// SPDX-License-Identifier: Apache-2.0
// Where projectiles start that would start inside something.
#include "sim_cuda/solver/way_back.h"

#include <gtest/gtest.h>

namespace demolish::tests {
namespace {

Projectile flying(const Double3& position, const Double3& velocity) {
    Projectile shot;
    shot.position = position;
    shot.velocity = velocity;
    shot.radius = 0.5;
    return shot;
}

TEST(WayBack, WhatTouchesNothingStaysWhereItIs) {
    const Projectile shot = flying({1, 2, 3}, {4, 0, 0});
    const Projectile placed = placedFree(shot, {{{3, 2, 3}, 1.4}}, {Plane{}});
    EXPECT_EQ(placed.position.x, 1);
    EXPECT_EQ(placed.position.y, 2);
    EXPECT_EQ(placed.position.z, 3);
}

TEST(WayBack, LeadsBackOnTheWayThatItCame) {
    const Projectile placed = placedFree(flying({0, 5, 0}, {4, 0, 0}), {{{0.5, 5, 0}, 1}}, {});
    EXPECT_NEAR(placed.position.x, 0.5 - 1.5, 1e-3);
    EXPECT_LT(placed.position.x, 0.5 - 1.5) << "clear of it";
    EXPECT_EQ(placed.position.y, 5);
    EXPECT_EQ(placed.velocity.x, 4);
}

TEST(WayBack, LeadsPastAllThatStandInARowAndNoFarther) {
    const std::vector<Ball> row{{{0, 5, 0}, 1}, {{-2, 5, 0}, 1}, {{-4, 5, 0}, 1}, {{-9, 5, 0}, 1}};
    const Projectile placed = placedFree(flying({0.2, 5, 0}, {3, 0, 0}), row, {});
    EXPECT_NEAR(placed.position.x, -5.5, 1e-3);
}

TEST(WayBack, WhatRestsGoesUp) {
    const Projectile placed = placedFree(flying({0, 5, 0}, {}), {{{0, 5, 0}, 1}}, {});
    EXPECT_NEAR(placed.position.y, 6.5, 1e-3);
}

TEST(WayBack, LeadsOutOfTheFloorAndThenOutOfWhatLiesThere) {
    const Projectile sunk = placedFree(flying({0, 0.1, 0}, {4, 0, 0}), {}, {Plane{}});
    EXPECT_NEAR(sunk.position.y, 0.5, 1e-3);
    EXPECT_GE(sunk.position.y, 0.5);
    const Projectile placed = placedFree(flying({0, 0.1, 0}, {4, 0, 0}), {{{0, 0.5, 0}, 0.5}}, {Plane{}});
    EXPECT_NEAR(placed.position.y, 0.5, 1e-3);
    EXPECT_NEAR(placed.position.x, -1, 1e-3);
}

}  // namespace
}  // namespace demolish::tests
