// SPDX-License-Identifier: Apache-2.0
// Balls: which come when, and that each touches its body in time with its velocity.
#include "app/session/ball_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/shot_setup.h"
#include "tests/unit/app/grid_cube.h"

namespace demolish {
namespace {

SceneBody standing(const Double3& position, double yaw, uint32_t variant) {
    SceneBody body;
    body.position = position;
    body.yaw = yaw;
    body.variant = variant;
    return body;
}

using test::gridCube;

SceneSetup cubes(const Shot& shot, int n) {
    const auto body = std::make_shared<const BreakableBody>(gridCube(n));
    return makeSetup(shot, BodyList(std::max<size_t>(1, shot.bodies.size()), body));
}

/// Where a ball is `t` s after its start, and its velocity there.
struct Flown {
    Double3 position, velocity;
};
Flown flown(const Projectile& ball, double t) {
    return {
        {ball.position.x + ball.velocity.x * t, ball.position.y + ball.velocity.y * t - 0.5 * 9.81 * t * t,
         ball.position.z + ball.velocity.z * t},
        {ball.velocity.x, ball.velocity.y - 9.81 * t, ball.velocity.z}};
}

TEST(BallFlight, TheBallTouchesTheSurfaceInTimeWithTheChosenVelocity) {
    for (const double velocity : {2.0, 10.0, 30.0}) {
        Shot shot;
        shot.impact.velocity = velocity;
        shot.impact.direction = {-1, 0, 0};
        const TimedBall timed = ballsOf(shot).at(0);
        const Projectile ball = makeBall(shot, cubes(shot, 12), timed, timed.flight_time).ball;
        EXPECT_DOUBLE_EQ(ball.radius, 1.0 / 12);
        const Flown at = flown(ball, shot.impact.arrival_time);
        EXPECT_NEAR(at.position.x, 0.5 + ball.radius, 0.02)
            << "one particle's depth is all that is known of the surface";
        EXPECT_NEAR(at.position.y, 0.5, 1e-9);
        EXPECT_NEAR(at.velocity.y, 0, 1e-9);
        EXPECT_NEAR(at.velocity.x, -velocity, 1e-9);
        EXPECT_GT(ball.position.y, ball.radius) << "starts above the floor";
    }
}

/// A wall across the way, or one in which the flight would begin: the ball starts on its near side.
TEST(BallFlight, ItStartsOnTheNearSideOfWalls) {
    Shot shot;
    shot.impact.velocity = 10;
    shot.impact.direction = {-1, 0, 0};
    const TimedBall timed = ballsOf(shot).at(0);
    const double free = makeBall(shot, cubes(shot, 12), timed, timed.flight_time).ball.position.x;
    for (const double wall : {free, 0.5 * (free + 0.5)}) {
        shot.colliders = {Box{{0.1, 4, 4}, {wall, 0, 0}, {}}};
        const ThrownBall thrown = makeBall(shot, cubes(shot, 12), timed, timed.flight_time);
        EXPECT_LT(thrown.ball.position.x, wall - 0.05 - thrown.ball.radius);
        EXPECT_NEAR(flown(thrown.ball, thrown.flight).position.x, 0.5 + thrown.ball.radius, 0.02);
        const Projectile clicked = makeBallAt(shot, gridCube(12), {free + 2, 0.5, 0}, {0.5, 0.5, 0});
        EXPECT_LT(clicked.position.x, wall - 0.05 - clicked.radius);
    }
}

TEST(BallFlight, WhatLiesFlatIsHitFromAbove) {
    BreakableBody plate = gridCube(12);
    for (Particle& particle : plate.particles) particle.seed.y *= 0.05;
    plate.bounds_max.y *= 0.05;
    Shot shot;
    shot.impact.velocity = 10;
    const TimedBall timed = ballsOf(shot).at(0);
    const Projectile ball =
        makeBall(shot, makeSetup(shot, {std::make_shared<BreakableBody>(plate)}), timed, timed.flight_time)
            .ball;
    EXPECT_DOUBLE_EQ(ball.radius, 1.0 / 12);
    EXPECT_NEAR(flown(ball, timed.flight_time).velocity.y, -10, 1e-9);
    EXPECT_GT(ball.position.y, 0.5);
}

TEST(BallFlight, ABallFindsItsBodyWhereItStands) {
    Shot shot;
    shot.impact.velocity = 10;
    shot.impact.direction = {-1, 0, 0};
    shot.bodies = {standing({0, 0, 0}, 0, 0), standing({4, 0, 2}, std::numbers::pi / 6, 0)};
    TimedBall timed;
    timed.body = 1;
    timed.speed_share = 0.5;
    timed.radius = 0.2;
    timed.height_fraction = 0.7;
    timed.direction = Double3{0, 0, 1};
    const Projectile ball = makeBall(shot, cubes(shot, 12), timed, 0.1).ball;
    EXPECT_DOUBLE_EQ(ball.radius, 0.2);
    const Flown at = flown(ball, 0.1);
    EXPECT_NEAR(at.velocity.z, 5, 1e-9);
    EXPECT_NEAR(at.position.x, 4, 1e-9);
    EXPECT_NEAR(at.position.y, 0.7, 1e-9);
    // A cube turned by 30 degrees: its side seen from -z is 0.5 / cos(30) from its middle.
    EXPECT_NEAR(at.position.z, 2 - 0.5 / std::cos(std::numbers::pi / 6) - 0.2, 0.06);
    EXPECT_LT(at.position.z, 2 - 0.6);
    timed.aim = Double3{0.3, 0.6, 0};  // turned with the body
    const Flown aimed = flown(makeBall(shot, cubes(shot, 12), timed, 0.1).ball, 0.1);
    EXPECT_NEAR(aimed.position.x, 4 + 0.3 * std::cos(std::numbers::pi / 6), 1e-9);
    EXPECT_NEAR(aimed.position.y, 0.6, 1e-9);
}

TEST(BallFlight, NothingHitsAtVelocityZero) {
    Shot shot;
    shot.impact.velocity = 0;
    EXPECT_TRUE(ballsOf(shot).empty());
    shot.balls.resize(3);
    EXPECT_TRUE(ballsOf(shot).empty());
    shot.impact.velocity = 5;
    EXPECT_EQ(ballsOf(shot).size(), 3u);
    shot.impact.kind = ImpactKind::kDrop;
    EXPECT_TRUE(ballsOf(shot).empty());
}

/// The frame, of `step` s, before which the ball starts; -1: never.
int startFrame(const TimedBall& ball, double step) {
    for (int frame = 0; frame * step < ball.arrival_time; ++frame)
        if (dueToStart(ball, frame * step, step)) return frame;
    return -1;
}

TEST(BallFlight, EveryBallStartsInTimeForItsFlight) {
    TimedBall ball;
    ball.flight_time = 0.12;
    ball.arrival_time = 0.12;
    EXPECT_EQ(startFrame(ball, 1.0 / 60), 0);
    ball.arrival_time = 1.0;
    const int frame = startFrame(ball, 1.0 / 60);
    EXPECT_LE(ball.arrival_time - frame / 60.0, 0.12 + 1e-6) << "not longer than asked for";
    EXPECT_GT(ball.arrival_time - frame / 60.0, 0.12 - 1.01 / 60) << "at most a frame shorter";
    // Frames longer than the flight: rather a long flight than a ball that comes out of nowhere.
    for (const double arrival : {0.12, 0.15, 0.3, 0.43, 0.99}) {
        ball.arrival_time = arrival;
        const int coarse = startFrame(ball, 1.0 / 7);
        ASSERT_GE(coarse, 0);
        EXPECT_GE(arrival - coarse / 7.0, 0.06) << arrival;
    }
}

TEST(BallFlight, AFlightThatWouldBeginUnderTheFloorIsShorter) {
    Shot shot;
    shot.impact.velocity = 2;
    const TimedBall timed = ballsOf(shot).at(0);
    const ThrownBall thrown = makeBall(shot, cubes(shot, 12), timed, 0.6);
    EXPECT_LT(thrown.flight, 0.4);
    EXPECT_GT(thrown.flight, 0.1);
    EXPECT_GT(thrown.ball.position.y, thrown.ball.radius);
    EXPECT_NEAR(flown(thrown.ball, thrown.flight).position.y, 0.5, 1e-9) << "and ends where it should";
    EXPECT_NEAR(flown(thrown.ball, thrown.flight).velocity.y, 0, 1e-9);
}

TEST(BallFlight, ALateImpactIsNotALongFlight) {
    Shot shot;
    shot.impact.arrival_time = 2;
    const TimedBall ball = ballsOf(shot).at(0);
    EXPECT_DOUBLE_EQ(ball.arrival_time, 2);
    EXPECT_LT(ball.flight_time, 0.2);
}

TEST(BallFlight, AShotAtAPointPassesIt) {
    const BreakableBody body = gridCube(8);
    Shot shot;
    shot.impact.velocity = 20;
    const Double3 target{0.5, 0.8, 0.1};
    const Projectile ball = makeBallAt(shot, body, {3, 1.2, 2}, target);
    double nearest = 1e9;
    for (double t = 0; t < 0.1; t += 1e-4) {
        const Double3 at = flown(ball, t).position;
        nearest = std::min(nearest, std::hypot(at.x - target.x, at.y - target.y, at.z - target.z));
    }
    EXPECT_LT(nearest, 0.01);
}

/// A frame of beams: its middle is a hole.
TEST(BallFlight, HitsTheMiddleOfWhatIsSeenAndNoHole) {
    BreakableBody body = gridCube(9);
    std::erase_if(body.particles, [&](const auto& particle) {
        return std::abs(particle.seed.x) < 0.3 && std::abs(particle.seed.y - 0.5) < 0.3;
    });
    Shot shot;
    shot.impact.direction = {0, 0, -1};
    const auto frame = std::make_shared<const BreakableBody>(body);
    const SceneSetup setup = makeSetup(shot, BodyList(1, frame));
    const auto at_touch = [&](const Shot& of) {
        const TimedBall timed = ballsOf(of).at(0);
        return flown(makeBall(of, setup, timed, timed.flight_time).ball, timed.flight_time).position;
    };
    const Double3 at = at_touch(shot);
    const double aside = std::max(std::abs(at.x), std::abs(at.y - 0.5));
    EXPECT_GT(aside, 0.3) << "on a beam";
    EXPECT_LT(aside, 0.5);
    EXPECT_NEAR(at.z, 0.5 + 1.0 / 12, 0.06);

    BreakableBody stair = gridCube(10);  // low on one side: the middle is not at half the height
    std::erase_if(stair.particles,
                  [](const auto& particle) { return particle.seed.x > 0 && particle.seed.y > 0.2; });
    const SceneSetup steps = makeSetup(shot, BodyList(1, std::make_shared<const BreakableBody>(stair)));
    const TimedBall timed = ballsOf(shot).at(0);
    const Double3 on =
        flown(makeBall(shot, steps, timed, timed.flight_time).ball, timed.flight_time).position;
    EXPECT_NEAR(on.x, -0.25 * 5 / 6 + 0.25 / 6, 0.08);
    EXPECT_NEAR(on.y, 0.5 * 5 / 6 + 0.1 / 6, 0.08);
    shot.impact.height_fraction = 0.7;
    EXPECT_NEAR(flown(makeBall(shot, steps, timed, timed.flight_time).ball, timed.flight_time).position.y,
                0.7, 1e-9);
}

}  // namespace
}  // namespace demolish
