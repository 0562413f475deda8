// SPDX-License-Identifier: Apache-2.0
// How a puff is slowed, grows, settles and fades.
#include "sim_cuda/effects/puff.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish {
namespace {

constexpr float kStep = static_cast<float>(kGrainStep);

Puff puffAt(const Vec3<float>& position, const Vec3<float>& velocity) {
    Puff puff;
    puff.position = position;
    puff.velocity = velocity;
    puff.first_radius = 0.01f;
    puff.first_depth = 0.2f;
    puff.life = 2;
    puff.slowing = 0.1f;
    return puff;
}
Surroundings open() {
    return {{0, -9.81f, 0}, makeColliderSet<float>({})};
}
Surroundings floorBelow() {
    return {{0, -9.81f, 0}, makeColliderSet<float>({Plane{}})};
}

TEST(Puff, FadingIsNearlyAnExponential) {
    EXPECT_EQ(fading(0), 1);
    for (double x = 0; x < 6; x += 0.05) EXPECT_NEAR(fading(static_cast<float>(x)), std::exp(-x), 0.03) << x;
}

TEST(Puff, TheAirSlowsItInItsTime) {
    Puff puff = puffAt({0, 1, 0}, {3, 0, 0});
    for (int step = 0; step < 120; ++step) movePuff(puff, open(), kStep);
    EXPECT_LT(puff.velocity.x, 3 * std::exp(-8.0));
    EXPECT_NEAR(puff.position.x, 3 * puff.slowing, 0.02);  // v0 tau
}

TEST(Puff, SwellsFastThenSlowlyAndThins) {
    Puff puff = puffAt({0, 1, 0}, {});
    float radius = radiusOf(puff);
    EXPECT_NEAR(radius, puff.first_radius, 1e-7);
    for (int step = 0; step < 200; ++step) {
        movePuff(puff, open(), kStep);
        EXPECT_GT(radiusOf(puff), radius);
        radius = radiusOf(puff);
    }
    EXPECT_NEAR(radius / puff.first_radius, 1 + kPuffSwell + kPuffGrowth * 200 * kStep, 0.1);
    EXPECT_NEAR(depthOf(puff) / puff.first_depth, puff.first_radius / radius * (1 - 200 * kStep / puff.life),
                1e-4);
    for (int step = 0; step < 60; ++step) movePuff(puff, open(), kStep);
    EXPECT_FALSE(isAlive(puff));
}

TEST(Puff, DustSettlesAndSmokeRises) {
    Puff dust = puffAt({0, 1, 0}, {}), smoke = dust;
    smoke.heat = 1;
    for (int step = 0; step < 240; ++step) {
        movePuff(dust, open(), kStep);
        movePuff(smoke, open(), kStep);
    }
    EXPECT_LT(dust.velocity.y, 0);
    EXPECT_NEAR(smoke.velocity.y, kSmokeRise, 1e-3);
    EXPECT_GT(smoke.position.y, 1.5);
}

TEST(Puff, SpreadsWhereTheFloorStopsIt) {
    Puff puff = puffAt({0, 0.1f, 0}, {0.5f, -2, 0});
    puff.slowing = 10;
    float fastest = 0;
    for (int step = 0; step < 60; ++step) {
        movePuff(puff, floorBelow(), kStep);
        fastest = std::max(fastest, puff.velocity.x);
    }
    EXPECT_GT(fastest, 1);
    EXPECT_GT(puff.position.y, 0.5f * kPuffHeight * radiusOf(puff));
}

}  // namespace
}  // namespace demolish
