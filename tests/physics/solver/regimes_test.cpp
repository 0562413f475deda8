// Only what is breaking pays: sleeping, waking, rigid motion of what no longer vibrates (architecture 9).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

struct Regimes {
    bool hand_over, sleeping;
};

SceneSetup with(SceneSetup setup, Regimes regimes) {
    setup.params.hand_over = regimes.hand_over;
    setup.params.sleeping = regimes.sleeping;
    return setup;
}

class Sleeping : public OnEitherDevice {};
class RigidMotion : public OnEitherDevice {};
class HandOver : public OnEitherDevice {};

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

TEST_F(Sleeping, ABodyHitInMidFrameBreaksExactlyAsIfItHadNeverSlept) {
    auto sleeper = makeSolver(with(brickHitInMidFrame(), {false, true}));
    auto awake = makeSolver(with(brickHitInMidFrame(), {false, false}));
    bool slept = false;
    for (int frame = 0; frame < 40; ++frame) {
        ASSERT_EQ(sleeper->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(awake->advanceFrame(), StepStatus::kOk);
        slept = slept || sleeper->stats().awake_particles == 0;
        ASSERT_EQ(sleeper->stateHash(), awake->stateHash()) << "frame " << frame;
    }
    EXPECT_TRUE(slept);
    EXPECT_GT(awake->stats().bonds_broken, 50u);
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

struct Outcome {
    FrameStats stats;
    uint64_t hash;
    bool handed_over, slept;
};

Outcome runBreaking(Regimes regimes, int frames) {
    SceneSetup setup = with(breakingScene(), regimes);
    auto solver = makeSolver(setup);
    Outcome outcome{};
    for (int frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        outcome.handed_over = outcome.handed_over || solver->stats().rigid_fragments > 1;
        outcome.slept = outcome.slept || solver->stats().sleeping_fragments > 0;
    }
    solver->measure();
    outcome.stats = solver->stats();
    outcome.hash = solver->stateHash();
    return outcome;
}

double energySum(const EnergyLedger& e) {
    return e.kinetic + e.elastic + e.potential + e.damping + e.friction + e.fracture - e.external;
}

TEST_F(HandOver, NeitherFragmentsNorLedgerTellWhetherItWasOn) {
    SceneSetup setup = breakingScene();
    auto start = makeSolver(setup);
    start->measure();
    const double initial = energySum(start->stats().energy);
    const Outcome off = runBreaking({false, false}, 90), on = runBreaking({true, true}, 90);
    EXPECT_TRUE(on.handed_over);
    EXPECT_TRUE(on.slept);
    EXPECT_LT(on.stats.bonded_particles, 64u);
    std::printf("broken %u %u  fragments %u %u  largest %.3f %.3f\n", off.stats.bonds_broken,
                on.stats.bonds_broken, off.stats.fragments, on.stats.fragments,
                off.stats.largest_fragment_fraction, on.stats.largest_fragment_fraction);
    const EnergyLedger &a = off.stats.energy, &b = on.stats.energy;
    std::printf("off k %.3f e %.3f p %.3f d %.3f f %.3f fr %.3f x %.3f sum %.4f of %.4f\n", a.kinetic,
                a.elastic, a.potential, a.damping, a.friction, a.fracture, a.external, energySum(a), initial);
    std::printf("on  k %.3f e %.3f p %.3f d %.3f f %.3f fr %.3f x %.3f sum %.4f\n", b.kinetic, b.elastic,
                b.potential, b.damping, b.friction, b.fracture, b.external, energySum(b));
}

TEST_F(HandOver, TwoRunsAndAnyThreadsGiveTheSameBits) {
    EXPECT_EQ(runBreaking({true, true}, 30).hash, runBreaking({true, true}, 30).hash);
}

}  // namespace
}  // namespace demolish::tests
