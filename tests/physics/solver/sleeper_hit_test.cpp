// SPDX-License-Identifier: Apache-2.0
// A sleeper that a ball flies at: it sleeps until its bonds are needed, and breaks as if it had never slept.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Sleeper : public OnEitherDevice {};

/// A brick on the floor, settled, and a ball that comes from `distance` m away.
SceneSetup brickAndBall(double distance, bool hand_over) {
    SceneSetup setup = freeBody(latticeBody(4, 6, 4, 0.03, 0.2));
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 150;
    setup.params.settle_time = 0.3;
    setup.params.sleeping = true;
    setup.params.hand_over = hand_over;
    Projectile ball;
    ball.radius = 0.03;
    ball.position = {-distance, 0.12, 0.003};
    ball.velocity = {9, 0, 0};
    setup.projectiles = {ball};
    return setup;
}

struct Hit {
    int frame = 0;        ///< in which the first bonds break
    uint32_t broken = 0;  ///< bonds, at its end
    bool stood = true;    ///< no particle of the brick moved before that frame
};
Hit hitOf(const SceneSetup& setup) {
    const size_t count = setup.bodies[0].body->particles.size();
    auto solver = makeSolver(setup);
    const auto start = exportedFrame(*solver, count).particles;
    for (Hit hit; hit.frame < 20; ++hit.frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        hit.broken = solver->stats().bonds_broken;
        if (hit.broken > 0) return hit;
        const auto now = exportedFrame(*solver, count).particles;
        for (size_t i = 0; i < count; ++i)
            hit.stood = hit.stood && now[i].position.x == start[i].position.x &&
                        now[i].position.y == start[i].position.y;
    }
    return {};
}

/// Rigid before the hit, it would sink into the floor, where contact steps are softer, and be hit in its
/// fall. The distances put the hit early, in the middle and late in a frame.
TEST_F(Sleeper, StandsUntilAHardHitAndBreaksAsWithBondsAlone) {
    int stood = 0;
    for (const double distance : {0.46, 0.50, 0.54, 0.58}) {
        const Hit handed = hitOf(brickAndBall(distance, true)), bonded = hitOf(brickAndBall(distance, false));
        std::printf("from %.2f m: %u bonds broken in frame %d, with bonds alone %u\n", distance,
                    handed.broken, handed.frame, bonded.broken);
        EXPECT_EQ(handed.stood, bonded.stood) << distance;
        stood += handed.stood ? 1 : 0;
        EXPECT_EQ(handed.frame, bonded.frame) << distance;
        EXPECT_GT(handed.frame, 1) << distance;
        // The ball falls in steps ten times as long: round-off, which a break can double.
        EXPECT_NEAR(handed.broken, bonded.broken, 1 + 0.02 * bonded.broken) << distance;
    }
    EXPECT_GE(stood, 2) << "in the other frames the ball touches before a bond breaks";
}

/// `painted`: times the strength of every other bond.
uint32_t brokenInASlowHit(double painted, double speed, bool hand_over) {
    SceneSetup setup = brickAndBall(0.1, hand_over);
    auto body = std::make_shared<BreakableBody>(*setup.bodies[0].body);
    body->bond_strength.assign(body->bonds.size(), 1);
    for (size_t b = 0; b < body->bonds.size(); b += 2) body->bond_strength[b] = painted;
    setup.bodies[0].body = body;
    setup.bodies[0].threshold_share = 3;  // as of a vase that a small ball hits
    setup.projectiles[0].velocity = {speed, 0, 0};
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 12; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    return solver->stats().bonds_broken;
}

/// What is painted weak breaks from less, and so its bonds wake from less.
TEST_F(Sleeper, PaintedWeakBreaksFromASlowHitAsWithBondsAlone) {
    EXPECT_EQ(brokenInASlowHit(1, 0.5, true), 0u);
    for (const double speed : {0.3, 0.5, 1.0}) {
        const uint32_t handed = brokenInASlowHit(0.1, speed, true),
                       bonded = brokenInASlowHit(0.1, speed, false);
        std::printf("at %.1f m/s: %u bonds broken, with bonds alone %u\n", speed, handed, bonded);
        EXPECT_GT(bonded, 10u);
        EXPECT_NEAR(handed, bonded, 1 + 0.2 * bonded);
    }
}

/// Long substeps: a stretch without bonds would last longer than contact lists hold, and a fast ball be deep
/// in a cell before anything woke.
TEST_F(Sleeper, IsAwakeWhenABallComesHoweverLongTheSubsteps) {
    constexpr double kSpeed = 100, kCell = 0.3, kArrives = 0.4;
    for (int k = 0; k < 12; ++k) {
        SceneSetup setup = freeBody(latticeBody(3, 3, 3, kCell));
        setup.params.substeps = 40;
        setup.params.sleeping = setup.params.hand_over = true;
        Projectile ball;
        ball.radius = 0.12;
        ball.position = {kSpeed * (kArrives + 0.0015 * k), 1.5 * kCell, 0.05};
        ball.velocity = {-kSpeed, 0, 0};
        setup.projectiles = {ball};
        auto solver = makeSolver(setup);
        solver->measure();
        const double before = energySum(solver->stats().energy);
        bool slept = false;
        for (int frame = 0; frame < 32; ++frame) {
            ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            slept = slept || solver->stats().sleeping_fragments > 0;
        }
        solver->measure();
        EXPECT_TRUE(slept);
        EXPECT_LT(solver->stats().energy.kinetic, 0.95 * before) << "it has been hit";
        EXPECT_NEAR(energySum(solver->stats().energy), before, 2e-3 * before) << k;
    }
}

}  // namespace
}  // namespace demolish::tests
