// SPDX-License-Identifier: Apache-2.0
// Ranges of a shot's values, and what a change of each costs.
#include "app/session/shot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

std::string complaint(double value) {
    try {
        requireInRange("--impact-velocity", value, kVelocityRange, "m/s");
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Shot, RangesRefuseWhatIsNoNumber) {
    EXPECT_EQ(complaint(0), "");
    EXPECT_EQ(complaint(200), "");
    EXPECT_EQ(complaint(-1), "--impact-velocity is -1 m/s; it must be between 0 and 200 m/s");
    EXPECT_THAT(complaint(std::nan("")), testing::HasSubstr("nan"));
    EXPECT_THAT(complaint(std::numeric_limits<double>::infinity()), testing::HasSubstr("inf"));
}

TEST(Shot, ValidateLooksAtEveryValue) {
    EXPECT_NO_THROW(validate(Shot{}));
    Shot shot;
    shot.impact.velocity = -3;
    EXPECT_THROW(validate(shot), UsageError);
    shot = {};
    shot.height = 0;
    EXPECT_THROW(validate(shot), UsageError);
    shot = {};
    shot.fineness.particle_size = std::nan("");
    EXPECT_THROW(validate(shot), UsageError);
    shot = {};
    shot.fineness.particles = 1;
    EXPECT_THROW(validate(shot), UsageError);
    shot = {};
    shot.time_scale = 0;
    EXPECT_THROW(validate(shot), UsageError);
}

TEST(Shot, ABallsVelocityIsLiveAndADropsIsNot) {
    const Shot before;
    Shot after = before;
    EXPECT_EQ(changeBetween(before, after), Change::kNothing);
    after.impact.velocity = 3;
    EXPECT_EQ(changeBetween(before, after), Change::kLive);
    Shot drop = before;
    drop.impact.kind = ImpactKind::kDrop;
    EXPECT_EQ(changeBetween(before, drop), Change::kSolver);
    after = drop;
    after.impact.velocity = 3;
    EXPECT_EQ(changeBetween(drop, after), Change::kSolver);
}

TEST(Shot, AVelocityToBreakAtAsksForANewSolverWithEveryAimOfTheBall) {
    const Shot before;
    Shot told = before;
    told.break_at = 6;
    EXPECT_EQ(changeBetween(before, told), Change::kSolver);
    Shot after = before;
    after.impact.ball_radius = 0.1;
    EXPECT_EQ(changeBetween(before, after), Change::kLive);
    after.break_at = told.break_at;
    EXPECT_EQ(changeBetween(told, after), Change::kSolver) << "another ball needs another strength";
    after = told;
    after.impact.velocity = 3;
    EXPECT_EQ(changeBetween(told, after), Change::kLive);
    told.break_at = 1000;
    EXPECT_THROW(validate(told), UsageError);
}

TEST(Shot, ValidateLooksAtEveryBallOfTheScene) {
    Shot shot;
    shot.balls.resize(2);
    shot.balls[1].speed_share = 3;
    shot.impact.velocity = 60;
    EXPECT_NO_THROW(validate(shot));
    shot.impact.velocity = 70;  // 210 m/s
    EXPECT_THROW(validate(shot), UsageError);
}

TEST(Shot, BallsAreLiveAndPlacesAreNot) {
    Shot before;
    before.balls.resize(2);
    before.bodies.resize(2);
    Shot after = before;
    EXPECT_EQ(changeBetween(before, after), Change::kNothing);
    for (const auto& edit : std::vector<void (*)(TimedBall&)>{[](TimedBall& ball) { ball.arrival_time = 2; },
                                                              [](TimedBall& ball) { ball.radius = 0.1; },
                                                              [](TimedBall& ball) {
                                                                  ball.direction = Double3{1, 0, 0};
                                                              },
                                                              [](TimedBall& ball) {
                                                                  ball.aim = Double3{0, 1, 0};
                                                              },
                                                              [](TimedBall& ball) { ball.body = 1; }}) {
        after = before;
        edit(after.balls[1]);
        EXPECT_EQ(changeBetween(before, after), Change::kLive);
    }
    after = before;
    after.balls.pop_back();
    EXPECT_EQ(changeBetween(before, after), Change::kLive);
    after = before;
    after.bodies[1].position.x = 1;
    EXPECT_EQ(changeBetween(before, after), Change::kBody);
    after = before;
    after.bodies[0].variant = 1;
    EXPECT_EQ(changeBetween(before, after), Change::kBody);
    after = before;
    after.repair.thickness = 0.01;
    EXPECT_EQ(changeBetween(before, after), Change::kBody);
    after = before;
    after.sleeping = false;
    EXPECT_EQ(changeBetween(before, after), Change::kSolver);
}

TEST(Shot, MaterialKeepsTheCellsAndParticleSizeDoesNot) {
    const Shot before;
    Shot after = before;
    after.material.critical_velocity *= 2;
    EXPECT_EQ(changeBetween(before, after), Change::kSolver);
    after = before;
    after.fineness.particle_size = 0.01;
    EXPECT_EQ(changeBetween(before, after), Change::kBody);
    after = before;
    after.model = "other.obj";
    EXPECT_EQ(changeBetween(before, after), Change::kBody);
    after = before;
    after.lighting.exposure = 2;
    EXPECT_EQ(changeBetween(before, after), Change::kNothing);
}

}  // namespace
}  // namespace demolish
