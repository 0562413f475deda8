// SPDX-License-Identifier: Apache-2.0
// How a grain flies, falls, bounces, slides and rests, against closed forms.
#include "sim_cuda/effects/grain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demolish {
namespace {

constexpr float kStep = static_cast<float>(kGrainStep);
constexpr float kGravity = 9.81f;

Surroundings emptySpace(float gravity) {
    return {{0, -gravity, 0}, makeColliderSet<float>({})};
}
Surroundings floorBelow() {
    return {{0, -kGravity, 0}, makeColliderSet<float>({Plane{}})};
}

Grain grainOf(float size, const Vec3<float>& position, const Vec3<float>& velocity) {
    Grain grain;
    grain.size = size;
    grain.position = position;
    grain.velocity = velocity;
    grain.drag = static_cast<float>(dragOf(2400));
    grain.seed = 7;
    return grain;
}

/// s until it rests or is gone.
double untilRest(Grain& grain, const Surroundings& around) {
    double time = 0;
    for (; isFlying(grain) && time < 20; time += kStep) moveGrain(grain, around, kStep);
    return time;
}

TEST(Grain, DragAloneFollowsItsClosedForm) {
    // v' = -k v^2 with k = c / size: v = v0 / (1 + k v0 t), which the implicit step meets exactly.
    Grain grain = grainOf(1e-3f, {}, {8, 0, 0});
    const double k = dragOf(2400) / 1e-3;
    for (int step = 0; step < 120; ++step) moveGrain(grain, emptySpace(0), kStep);
    EXPECT_NEAR(grain.velocity.x, 8 / (1 + k * 8 * 120 * kStep), 1e-4);
    // x = ln(1 + k v0 t) / k; a step of 1/120 s is first order.
    EXPECT_NEAR(grain.position.x, std::log(1 + k * 8 * 120 * kStep) / k, 0.03);
}

TEST(Grain, FallsToItsTerminalVelocity) {
    for (const float size : {2e-4f, 1e-3f, 5e-3f}) {
        Grain grain = grainOf(size, {}, {});
        for (int step = 0; step < 600; ++step) moveGrain(grain, emptySpace(kGravity), kStep);
        EXPECT_NEAR(-grain.velocity.y / std::sqrt(kGravity * size / dragOf(2400)), 1, 0.06) << size;
    }
}

TEST(Grain, ALargeOneFallsFreely) {
    Grain grain = grainOf(1.0f, {}, {1, 0, 0});
    for (int step = 0; step < 60; ++step) moveGrain(grain, emptySpace(kGravity), kStep);
    EXPECT_NEAR(grain.position.y, -0.5 * kGravity * 0.25, 0.03);
    EXPECT_NEAR(grain.position.x, 0.5, 1e-3);
}

TEST(Grain, BouncesLowerEachTimeAndComesToRestOnTheFloor) {
    Grain grain = grainOf(2e-3f, {0, 1, 0}, {1, 0, 0.5f});
    float highest = 1, before = 1;
    while (isFlying(grain)) {
        const float falling = grain.velocity.y;
        const uint32_t bounces = grain.bounces;
        moveGrain(grain, floorBelow(), kStep);
        if (grain.bounces == bounces) continue;
        EXPECT_GT(grain.velocity.y, 0);
        // e lies between half and one and a half of 0.25, and a sixth of the rebound is strewn.
        EXPECT_LT(grain.velocity.y, 1.2f * 1.5f * kGrainBounce * -falling);
        before = highest;
        highest = grain.velocity.y * grain.velocity.y / (2 * kGravity);
        EXPECT_LT(highest, before);
    }
    EXPECT_GE(grain.bounces, 1u);
    EXPECT_EQ(length(grain.velocity), 0);
    EXPECT_NEAR(grain.position.y, kGrainHeight * grain.size, 1e-6);
    const Grain rested = grain;
    moveGrain(grain, floorBelow(), 0);  // what rests is not moved by its kernel; nor would it sink
    EXPECT_EQ(rested.position.x, grain.position.x);
}

TEST(Grain, SlidesAsFarAsFrictionSays) {
    const float size = 0.02f;  // so large that air hardly slows it
    Grain grain = grainOf(size, {0, kGrainHeight * size, 0}, {1.2f, 0, 0});
    untilRest(grain, floorBelow());
    EXPECT_FALSE(isFlying(grain));
    EXPECT_GT(grain.size, 0);
    EXPECT_NEAR(grain.position.x, 1.2 * 1.2 / (2 * kSlideFriction), 0.02);
}

TEST(Grain, RestsOnABoxAndSlidesOffASteepPlane) {
    const Surroundings box{{0, -kGravity, 0},
                           makeColliderSet<float>({Plane{}, Box{{1, 0.4, 1}, {0, 0.2, 0}, {}}})};
    Grain on_box = grainOf(2e-3f, {0.1f, 0.6f, 0}, {});
    untilRest(on_box, box);
    EXPECT_NEAR(on_box.position.y, 0.4 + kGrainHeight * 2e-3, 1e-5);

    const double s = std::sqrt(0.5);
    const Surroundings slope{{0, -kGravity, 0}, makeColliderSet<float>({Plane{}, Plane{{s, s, 0}, 0}})};
    Grain on_slope = grainOf(2e-3f, {-0.3f, 0.5f, 0}, {});
    untilRest(on_slope, slope);
    EXPECT_NEAR(on_slope.position.y, kGrainHeight * 2e-3, 1e-5);  // at its foot
    EXPECT_GT(on_slope.position.x, -0.01);
}

TEST(Grain, WhoFliesForEverIsGone) {
    Grain grain = grainOf(1e-3f, {}, {});
    const double time = untilRest(grain, emptySpace(kGravity));
    EXPECT_EQ(grain.size, 0);
    EXPECT_NEAR(time, kLongestFlight, 0.05);
}

TEST(Grain, AHardMeetingStaysFinite) {
    Grain grain = grainOf(1e-6f, {0, 1, 0}, {0, -1e6f, 3e5f});
    untilRest(grain, floorBelow());
    EXPECT_TRUE(std::isfinite(grain.position.y) && std::isfinite(grain.position.z));
    EXPECT_GE(grain.position.y, 0);
}

}  // namespace
}  // namespace demolish
