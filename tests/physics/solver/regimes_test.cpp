// SPDX-License-Identifier: Apache-2.0
// Only what is breaking pays: sleeping, waking, rigid motion of what no longer vibrates (architecture 9).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "sim_cuda/physics/hand_over.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Sleeping : public OnEitherDevice {};
class WakeSpeed : public OnTheCpu {};
class RigidMotion : public OnEitherDevice {};

double lengthOf(const Double3& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}
Double3 minus(const Double3& a, const Double3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// A brick of brittle ceramic at rest, far from everything, hit by a ball in the middle of the third frame.
SceneSetup brickHitInMidFrame() {
    SceneSetup setup = freeBody(latticeBody(6, 6, 6, 1.0 / 64));
    setup.bodies[0].material = brittleMaterial();
    setup.params.substeps = 120;
    Projectile ball;
    ball.radius = 0.02;
    ball.position = {0.2, 0.06, 0.002};
    ball.velocity = {-8, 0, 0};
    ball.start_time = 0.55;
    setup.projectiles = {ball};
    return setup;
}

/// A frame of each.
void advanceBoth(Solver& one, Solver& other) {
    for (Solver* solver : {&one, &other}) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
}

TEST_F(Sleeping, ABodyHitInMidFrameBreaksExactlyAsIfItHadNeverSlept) {
    auto sleeper = makeSolver(with(brickHitInMidFrame(), {false, true}));
    auto awake = makeSolver(with(brickHitInMidFrame(), {false, false}));
    bool slept = false;
    for (int frame = 0; frame < 40; ++frame) {
        ASSERT_NO_FATAL_FAILURE(advanceBoth(*sleeper, *awake));
        slept = slept || sleeper->stats().awake_particles == 0;
        ASSERT_EQ(sleeper->stateHash(), awake->stateHash()) << "frame " << frame;
    }
    EXPECT_TRUE(slept);
    EXPECT_GT(awake->stats().bonds_broken, 50u);
}

/// The ball has been on its way for frames, and is near the brick's contact lists before it touches.
TEST_F(Sleeping, ABodyHitByABallFromAfarBreaksExactlyAsIfItHadNeverSlept) {
    SceneSetup setup = brickHitInMidFrame();
    setup.projectiles[0].position.x = 3.2;
    setup.projectiles[0].start_time = 0;
    auto sleeper = makeSolver(with(setup, {false, true}));
    auto awake = makeSolver(with(setup, {false, false}));
    bool slept = false;
    for (int frame = 0; frame < 35; ++frame) {
        ASSERT_NO_FATAL_FAILURE(advanceBoth(*sleeper, *awake));
        slept = slept || sleeper->stats().sleeping_fragments == 1;
        ASSERT_EQ(sleeper->stateHash(), awake->stateHash()) << "frame " << frame;
    }
    EXPECT_TRUE(slept);
    EXPECT_GT(awake->stats().bonds_broken, 50u);
}

/// While another one is on its way, and near enough to hit before anything has to be decided again.
TEST_F(Sleeping, ABallThatHasJustStartedWakesWhatItWillHit) {
    SceneSetup setup = brickHitInMidFrame();
    setup.projectiles[0].position.x = 0.4;
    setup.projectiles[0].velocity.x = -40;
    Projectile slow = setup.projectiles[0];
    slow.position = {0, 6, 3};
    slow.velocity = {0.5, 0, 0};
    slow.start_time = 0.3;
    setup.projectiles.insert(setup.projectiles.begin(), slow);
    auto sleeper = makeSolver(with(setup, {true, true}));
    auto awake = makeSolver(with(setup, {false, false}));
    bool slept = false;
    for (int frame = 0; frame < 36; ++frame) {
        ASSERT_NO_FATAL_FAILURE(advanceBoth(*sleeper, *awake));
        slept = slept || sleeper->stats().sleeping_fragments == 1;
    }
    EXPECT_TRUE(slept);
    const double broken = awake->stats().bonds_broken;
    EXPECT_GT(broken, 300);
    EXPECT_NEAR(sleeper->stats().bonds_broken, broken, 0.05 * broken);
}

/// A brick that flies and spins, whole; bonds have nothing to do.
SceneSetup flyingBrick() {
    SceneSetup setup = freeBody(latticeBody(3, 4, 6, 0.05, 0.2));
    setup.bodies[0].velocity = {0.5, 1, -0.3};
    setup.bodies[0].angular_velocity = {2, 9, 1};
    setup.params.substeps = 200;
    return setup;
}

TEST_F(RigidMotion, AFlyingBodyKeepsMomentaAndEnergyAndCostsNoBonds) {
    auto solver = makeSolver(with(flyingBrick(), {true, true}));
    // The bonds swing when the spin sets in, and must come to rest first.
    for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    ASSERT_EQ(solver->stats().bonded_particles, 0u);
    ASSERT_EQ(solver->stats().rigid_fragments, 1u);
    solver->measure();
    const FrameStats before = solver->stats();
    for (int frame = 0; frame < 120; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const FrameStats after = solver->stats();
    EXPECT_LT(lengthOf(minus(after.linear_momentum, before.linear_momentum)),
              1e-5 * lengthOf(before.linear_momentum));
    EXPECT_LT(lengthOf(minus(after.angular_momentum, before.angular_momentum)),
              1e-4 * lengthOf(before.angular_momentum));
    EXPECT_NEAR(after.energy.kinetic, before.energy.kinetic, 1e-4 * before.energy.kinetic);
    EXPECT_EQ(after.bonds_broken, 0u);
}

TEST_F(RigidMotion, TheWayIsThatOfTheBonds) {
    if (asksForGpu()) GTEST_SKIP() << "frames are written into host memory here";
    auto rigid = makeSolver(with(flyingBrick(), {true, false}));
    auto bonded = makeSolver(with(flyingBrick(), {false, false}));
    for (int frame = 0; frame < 90; ++frame) {
        ASSERT_EQ(rigid->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(bonded->advanceFrame(), StepStatus::kOk);
    }
    ASSERT_EQ(rigid->stats().bonded_particles, 0u);
    std::vector<FragmentTransform> a(72 + kMaxProjectiles), b(a.size());
    RenderStreams streams;
    streams.transforms = {a.data(), a.size()};
    rigid->exportFrame(streams, true);
    streams.transforms = {b.data(), b.size()};
    bonded->exportFrame(streams, true);
    EXPECT_NEAR(a[0].translation.x, b[0].translation.x, 2e-3);
    EXPECT_NEAR(a[0].translation.y, b[0].translation.y, 2e-3);
    const float turned = a[0].rotation.x * b[0].rotation.x + a[0].rotation.y * b[0].rotation.y +
                         a[0].rotation.z * b[0].rotation.z + a[0].rotation.w * b[0].rotation.w;
    EXPECT_GT(std::abs(turned), 0.999f);
}

/// A block of 216 cells that lands on its face or, turned about x, on an edge; too slow to break.
SceneSetup landingBlock(double turn) {
    SceneSetup setup = freeBody(latticeBody(6, 6, 6, 0.03));
    setup.bodies[0].threshold_share = 10;
    setup.bodies[0].material.critical_velocity = 10;
    setup.bodies[0].rotation = {static_cast<float>(std::sin(turn / 2)), 0, 0,
                                static_cast<float>(std::cos(turn / 2))};
    setup.bodies[0].position = {0, 0.04 + 0.09 * std::abs(std::sin(turn)), 0};
    setup.bodies[0].velocity = {0, -0.3, 0};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 200;
    return setup;
}

struct Landing {
    double most = 0;  ///< kinetic and potential energy after the block has touched, over that before
    double end = 0;   ///< likewise, after half a second
    uint32_t most_rigid = 0, broken = 0;
};
Landing landed(const SceneSetup& setup) {
    auto solver = makeSolver(setup);
    const auto measured = [&] {
        solver->measure();
        const EnergyLedger& e = solver->stats().energy;
        return e.kinetic + e.potential;
    };
    Landing landing;
    const double start = measured();
    for (int frame = 0; frame < 30; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        landing.most_rigid = std::max(landing.most_rigid, solver->stats().rigid_fragments);
        landing.end = measured() / start;
        if (frame >= 8) landing.most = std::max(landing.most, landing.end);
    }
    landing.broken = solver->stats().bonds_broken;
    return landing;
}

/// Flat, 36 contacts come at once: with the mass shared among four of them at first the block was thrown back
/// with many times its energy. On an edge it bounces and rocks, as it does with its bonds.
TEST_F(RigidMotion, ALandingGainsNothingAndGivesBackAsBondsDo) {
    for (const double turn : {0.0, 0.4}) {
        const Landing rigid = landed(with(landingBlock(turn), {true, false}));
        const Landing bonded = landed(with(landingBlock(turn), {false, false}));
        std::printf("turned %.1f: rigid %.3f, then %.3f; bonded %.3f, then %.3f\n", turn, rigid.most,
                    rigid.end, bonded.most, bonded.end);
        EXPECT_EQ(rigid.most_rigid, 1u);
        EXPECT_EQ(rigid.broken + bonded.broken, 0u);
        EXPECT_LT(rigid.most, 1);
        EXPECT_NEAR(rigid.most, bonded.most, 0.15);
        EXPECT_NEAR(rigid.end, bonded.end, 0.03);
    }
}

/// Two bricks side by side on the floor, settled; one is hit.
SceneSetup twoBricks() {
    SceneSetup setup = freeBody(latticeBody(4, 6, 4, 0.03, 0.2));
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {20, 0, 0};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 150;
    setup.params.settle_time = 0.3;
    Projectile ball;
    ball.radius = 0.03;
    ball.position = {-0.3, 0.1, 0};
    ball.velocity = {9, 0, 0};
    setup.projectiles = {ball};
    return setup;
}

/// Settling moves everything with its bonds, before anything is decided about fragments.
TEST_F(Sleeping, BodiesSettleAlikeWhetherTheyMaySleepOrNot) {
    auto sleeper = makeSolver(with(twoBricks(), {true, true})),
         awake = makeSolver(with(twoBricks(), {false, false}));
    EXPECT_EQ(sleeper->stateHash(), awake->stateHash());
    SceneSetup unsettled = twoBricks();
    unsettled.params.settle_time = 0;
    EXPECT_NE(makeSolver(unsettled)->stateHash(), awake->stateHash());
}

TEST_F(Sleeping, CostFollowsWhatIsAwake) {
    auto solver = makeSolver(with(twoBricks(), {true, true}));
    uint32_t most_awake_bodies = 0;
    for (int frame = 0; frame < 30; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        most_awake_bodies = std::max(most_awake_bodies, solver->stats().awake_bodies);
        EXPECT_LE(solver->stats().awake_particles, 96u + kMaxProjectiles) << "frame " << frame;
        EXPECT_GE(solver->stats().sleeping_fragments, 1u);
    }
    EXPECT_EQ(most_awake_bodies, 1u);
    EXPECT_GT(solver->stats().bonds_broken, 20u);
}

TEST_F(Sleeping, ARestoredStateGoesOnExactly) {
    const SceneSetup setup = with(breakingScene(), {true, true});
    auto solver = makeSolver(setup), other = makeSolver(setup);
    for (int frame = 0; frame < 25; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    other->restore(solver->save());
    for (int frame = 0; frame < 10; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(other->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(other->stateHash(), solver->stateHash()) << "frame " << frame;
    }
}

/// What is light must come faster; what is as heavy as the body, or does not move at all, need not.
TEST_F(WakeSpeed, RisesByTheFourthRootAsTheTwoGetLighter) {
    const WakeLaw<double> body = wakeLaw(0.4, 6, 0.5, 1600), ball{1e30, 1e30, 1e30};
    const double heavy = kWakeShare * 0.5 * 6;
    EXPECT_NEAR(wakeSpeed(body, ball, 1600.0, 1e9), heavy, 1e-6);
    EXPECT_NEAR(wakeSpeed(body, body, 1600.0, 1600.0), heavy * std::pow(2.0, 0.25), 1e-9);
    EXPECT_NEAR(wakeSpeed(body, body, 100.0, 1e9), 2 * heavy, 1e-5);
    EXPECT_EQ(wakeSpeed(body, body, 30.0, 700.0), wakeSpeed(body, body, 700.0, 30.0));
    EXPECT_GT(wakeSpeed(body, body, 1.0, 1600.0), 6 * heavy);
    EXPECT_NEAR(wakeSpeed(wakeLaw(0.4, 6, 1e-3, 1600), ball, 4.0, 1e9), 0.4 * 6 / 2, 1e-6);
}

class Carrying : public OnEitherDevice {};

/// Two bricks in free space; a ball breaks the first, whose pieces fly into the second, which another
/// breaks while they do.
SceneSetup brickIntoBrick() {
    SceneSetup setup = freeBody(latticeBody(5, 5, 5, 0.02));
    setup.bodies[0].material = brittleMaterial();
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {0.16, 0.003, 0.001};
    setup.params.substeps = 150;
    Projectile ball;
    ball.radius = 0.02;
    ball.position = {-0.2, 0.047, 0.052};
    ball.velocity = {8, 0, 0};
    setup.projectiles = {ball};
    ball.position = {0.2, 0.92, 0.04};
    ball.velocity = {0, -8, 0};
    setup.projectiles.push_back(ball);
    return setup;
}

/// Energy as with bonds alone, whose hard hits gain some: over two hits half a per cent.
TEST_F(Carrying, FragmentsOfBothKindsExchangeMomentaToRoundOff) {
    auto bonded = makeSolver(with(brickIntoBrick(), {false, false}));
    for (int frame = 0; frame < 32; ++frame) ASSERT_EQ(bonded->advanceFrame(), StepStatus::kOk);
    bonded->measure();
    const double booked = energySum(bonded->stats().energy);
    auto solver = makeSolver(with(brickIntoBrick(), {true, true}));
    for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const FrameStats before = solver->stats();
    uint32_t frames_carrying = 0;
    for (int frame = 0; frame < 30; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        const FrameStats& now = solver->stats();
        if (now.carried_particles > 0 && now.bonded_particles > 0) ++frames_carrying;
    }
    solver->measure();
    const FrameStats after = solver->stats();
    EXPECT_GE(frames_carrying, 3u);
    EXPECT_GT(after.bonds_broken, 50u);
    EXPECT_LT(lengthOf(minus(after.linear_momentum, before.linear_momentum)),
              1e-5 * lengthOf(before.linear_momentum));
    EXPECT_LT(lengthOf(minus(after.angular_momentum, before.angular_momentum)),
              1e-3 * lengthOf(before.angular_momentum));
    EXPECT_NEAR(energySum(after.energy), booked, 2e-3 * booked);
    EXPECT_NEAR(booked, energySum(before.energy), 8e-3 * booked);
}

/// Six bricks side by side on the floor, each touching the next.
SceneSetup rowOfBricks() {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.03, 0.2));
    setup.bodies[0].material = brittleMaterial();
    for (int k = 1; k < 6; ++k) {
        setup.bodies.push_back(setup.bodies[0]);
        setup.bodies[k].position = {0.12 * k, 0, 0};
    }
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 150;
    setup.params.settle_time = 0.3;
    Projectile ball;
    ball.radius = 0.02;
    ball.position = {0.06, 0.3, 0.06};
    ball.velocity = {0, -6, 0};
    setup.projectiles = {ball};
    return setup;
}

TEST_F(Carrying, AHardHitBringsBackTheBondsOfWhatItHitsAlone) {
    auto solver = makeSolver(with(rowOfBricks(), {true, true}));
    uint32_t most_bonded = 0, frames_carrying = 0;
    for (int frame = 0; frame < 20; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        const FrameStats& now = solver->stats();
        most_bonded = std::max(most_bonded, now.bonded_particles);
        if (now.carried_particles > 0) ++frames_carrying;
    }
    EXPECT_GT(solver->stats().bonds_broken, 15u);
    EXPECT_GT(frames_carrying, 2u);
    EXPECT_LE(most_bonded, 4u * 64u) << "of " << solver->stats().particles;
}

}  // namespace
}  // namespace demolish::tests
