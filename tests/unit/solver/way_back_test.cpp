// SPDX-License-Identifier: Apache-2.0
// Where projectiles start that would start inside something.
#include "sim_cuda/solver/way_back.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// A slow ball is aimed upwards: its way back leads into the floor, and along it out of what stands there.
TEST(WayBack, LeadsAlongTheFloorOutOfAWideBody) {
    std::vector<Ball> body;
    for (int k = 0; k < 30; ++k) body.push_back({{-0.4 * k, 0.5, 0}, 0.5});
    const auto overlaps = [&](const Projectile& ball) {
        return std::any_of(body.begin(), body.end(), [&](const Ball& other) {
            const Vec3<double> at{ball.position.x, ball.position.y, ball.position.z};
            return length(other.centre - at) < other.radius + ball.radius;
        });
    };
    const Projectile placed = placedFree(flying({0, 1, 0}, {1, 3, 0}), body, {Plane{}});
    EXPECT_FALSE(overlaps(placed)) << placed.position.x;
    EXPECT_NEAR(placed.position.y, 0.5, 1e-3);
    EXPECT_LT(placed.position.x, -12);
    const Projectile straight_up = placedFree(flying({-6, 1, 0}, {0, 3, 0}), body, {Plane{}});
    EXPECT_FALSE(overlaps(straight_up));
    EXPECT_GT(straight_up.position.y, 1);
}

}  // namespace
}  // namespace demolish::tests
