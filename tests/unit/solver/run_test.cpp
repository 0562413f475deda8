// SPDX-License-Identifier: Apache-2.0
// Runs: the same for any number of threads, restorable, and stopped before anything bad reaches a buffer.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "sim_cuda/api/errors.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

uint64_t hashWithThreads(size_t threads, uint32_t substeps) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    auto solver = makeCpuSolver(breakingScene());
    EXPECT_EQ(solver->advanceSubsteps(substeps), StepStatus::kOk);
    EXPECT_GT(solver->stats().bonds_broken, 100u);
    return solver->stateHash();
}

TEST(SolverRun, OneAndTwoAndFourThreadsGiveTheSameBits) {
    const uint64_t one = hashWithThreads(1, 900);
    EXPECT_EQ(hashWithThreads(2, 900), one);
    EXPECT_EQ(hashWithThreads(4, 900), one);
}

TEST(SolverRun, TheLedgerChangesNothing) {
    SceneSetup setup = breakingScene();
    auto with = makeCpuSolver(setup);
    setup.params.ledger = false;
    auto without = makeCpuSolver(setup);
    ASSERT_EQ(with->advanceSubsteps(600), StepStatus::kOk);
    ASSERT_EQ(without->advanceSubsteps(600), StepStatus::kOk);
    EXPECT_EQ(with->stateHash(), without->stateHash());
    EXPECT_GT(with->stats().energy.fracture, 0);
    EXPECT_EQ(without->stats().energy.fracture, 0);
}

TEST(SolverRun, MeasuringChangesNothing) {
    auto measured = makeCpuSolver(breakingScene()), left_alone = makeCpuSolver(breakingScene());
    for (int k = 0; k < 3; ++k) {
        measured->measure();
        ASSERT_EQ(measured->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(left_alone->advanceFrame(), StepStatus::kOk);
    }
    measured->measure();
    EXPECT_EQ(measured->stateHash(), left_alone->stateHash());
}

TEST(SolverRun, ARestoredStateGoesOnExactly) {
    auto solver = makeCpuSolver(breakingScene());
    for (int k = 0; k < 2; ++k) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const Snapshot snapshot = solver->save();
    const uint64_t saved = solver->stateHash();
    for (int k = 0; k < 2; ++k) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const uint64_t later = solver->stateHash();
    const double damping = solver->stats().energy.damping;
    ASSERT_NE(later, saved);
    solver->restore(snapshot);
    EXPECT_EQ(solver->stateHash(), saved);
    auto other = makeCpuSolver(breakingScene());
    other->restore(snapshot);
    for (Solver* restored : {solver.get(), other.get()}) {
        for (int k = 0; k < 2; ++k) ASSERT_EQ(restored->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(restored->stateHash(), later);
        EXPECT_EQ(restored->stats().energy.damping, damping);
        EXPECT_EQ(restored->stats().frame, 4u);
    }
}

/// What breaks, with pieces that are handed over and sleep.
SceneSetup regimesScene() {
    SceneSetup setup = breakingScene();
    setup.params.hand_over = setup.params.sleeping = true;
    return setup;
}

TEST(SolverRun, AFrameInSlicesGivesTheSameBits) {
    for (const SceneSetup& setup : {breakingScene(), regimesScene()}) {
        auto sliced = makeCpuSolver(setup), whole = makeCpuSolver(setup);
        double last = 0;
        int slices = 0;
        const auto stop = [&](double share) {
            EXPECT_GT(share, last);
            EXPECT_LT(share, 1);
            last = share;
            ++slices;
            return slices % 3 != 0;
        };
        for (int frame = 0; frame < 12; ++frame) {
            ASSERT_EQ(whole->advanceFrame(), StepStatus::kOk);
            last = 0;
            do {
                EXPECT_EQ(sliced->stats().frame, static_cast<uint64_t>(frame));
                ASSERT_EQ(sliced->advanceFrame(1, stop), StepStatus::kOk);
            } while (sliced->frameUnfinished());
            ASSERT_EQ(sliced->stateHash(), whole->stateHash());
            EXPECT_EQ(sliced->stats().substeps, whole->stats().substeps);
            EXPECT_EQ(sliced->stats().list_rebuilds, whole->stats().list_rebuilds);
        }
        EXPECT_GT(slices, 30);
        EXPECT_GT(whole->stats().bonds_broken, 100u);
        EXPECT_EQ(sliced->stats().energy.damping, whole->stats().energy.damping);
    }
}

TEST(SolverRun, AFrameThatIsGivenUpLeavesTheOneBefore) {
    auto given_up = makeCpuSolver(regimesScene()), whole = makeCpuSolver(regimesScene());
    for (int frame = 0; frame < 8; ++frame) {
        const uint64_t before = given_up->stateHash();
        const uint32_t broken = given_up->stats().bonds_broken, awake = given_up->stats().awake_particles;
        for (const double until : {0.0, 0.8}) {
            ASSERT_EQ(given_up->advanceFrame(1, [&](double share) { return share < until; }),
                      StepStatus::kOk);
            ASSERT_TRUE(given_up->frameUnfinished());
            given_up->giveUpFrame();
            EXPECT_FALSE(given_up->frameUnfinished());
            EXPECT_EQ(given_up->stateHash(), before);
            EXPECT_EQ(given_up->stats().frame, static_cast<uint64_t>(frame));
            EXPECT_EQ(given_up->stats().bonds_broken, broken);
            EXPECT_EQ(given_up->stats().awake_particles, awake);
        }
        ASSERT_EQ(given_up->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(whole->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(given_up->stateHash(), whole->stateHash());
    }
    EXPECT_GT(whole->stats().bonds_broken, 100u);
}

TEST(SolverRun, RestoringForgetsAnUnfinishedFrame) {
    auto solver = makeCpuSolver(regimesScene());
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const Snapshot snapshot = solver->save();
    const uint64_t saved = solver->stateHash();
    ASSERT_EQ(solver->advanceFrame(1, [](double) { return false; }), StepStatus::kOk);
    solver->restore(snapshot);
    EXPECT_FALSE(solver->frameUnfinished());
    EXPECT_EQ(solver->stateHash(), saved);
}

TEST(SolverRun, SettlingCanBeCancelledAtAnyStretch) {
    SceneSetup setup = breakingScene();
    setup.params.settle_time = 0.5;
    int asked = 0;
    const auto cancel = [&](double, const char* stage) {
        return std::string(stage) != "Settling" || ++asked < 2;
    };
    EXPECT_THROW(makeCpuSolver(setup, cancel), Cancelled);
    EXPECT_EQ(asked, 2);
}

TEST(SolverRun, ASnapshotOfAnotherSceneIsRefused) {
    const Snapshot snapshot = makeCpuSolver(breakingScene())->save();
    EXPECT_THROW(makeCpuSolver(freeBody(latticeBody(2, 2, 2, 0.1)))->restore(snapshot), UsageError);
    EXPECT_THROW(makeCpuSolver(breakingScene())->restore(Snapshot{}), UsageError);
}

TEST(SolverRun, AHugeVelocityStopsTheStepAndLeavesTheFrameBefore) {
    auto solver = makeCpuSolver(freeBody(latticeBody(3, 3, 3, 0.1)));
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const uint64_t before = solver->stateHash();
    Projectile shot;
    shot.position = {-0.3, 0.15, 0};
    shot.velocity = {1e20, 0, 0};
    solver->fire(shot);
    const uint64_t fired = solver->stateHash();
    const StepStatus status = solver->advanceFrame();
    EXPECT_TRUE(has(status, StepStatus::kNotFinite)) << describe(status);
    EXPECT_EQ(solver->stats().status, status);
    EXPECT_EQ(solver->stats().frame, 1u);
    EXPECT_EQ(solver->stateHash(), fired);
    EXPECT_NE(before, fired);
    EXPECT_NE(describe(status).find("impact velocity"), std::string::npos);
}

TEST(SolverRun, LeavingTheSceneIsSaid) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    setup.bodies[0].velocity = {40, 0, 0};
    setup.params.scene_radius = 1;
    auto solver = makeCpuSolver(setup);
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_EQ(solver->advanceFrame(), StepStatus::kLeftScene);
    EXPECT_EQ(solver->stats().frame, 1u);
}

TEST(SolverRun, AProjectileStartsInsideAFrameAtItsTime) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    Projectile shot;
    shot.position = {5, 0, 0};
    shot.velocity = {0, 6, 0};
    shot.start_time = 0.02;  // 1.2 frames
    setup.projectiles.push_back(shot);
    auto solver = makeCpuSolver(setup);
    for (int k = 0; k < 2; ++k) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    std::vector<ParticleInstance> particles(8 + kMaxProjectiles);
    RenderStreams streams;
    streams.particles = {particles.data(), particles.size()};
    solver->exportFrame(streams);
    EXPECT_NEAR(particles[8].position.y, 6 * (2.0 / 60 - 0.02), 1e-5);
    EXPECT_NEAR(particles[8].radius, 0.05, 1e-6);
    EXPECT_EQ(particles[9].radius, 0);
}

TEST(SolverRun, SlowMotionTakesFewerSubsteps) {
    auto solver = makeCpuSolver(freeBody(latticeBody(2, 2, 2, 0.1)));
    ASSERT_EQ(solver->advanceFrame(0.1), StepStatus::kOk);
    EXPECT_EQ(solver->stats().substeps, 30u);
    EXPECT_NEAR(solver->stats().time, 1.0 / 600, 1e-9);
    EXPECT_THROW(solver->advanceFrame(0), UsageError);
}

TEST(SolverRun, SixteenShotsAndNoMore) {
    auto solver = makeCpuSolver(freeBody(latticeBody(2, 2, 2, 0.1)));
    Projectile shot;
    shot.position = {9, 9, 9};
    for (uint32_t k = 0; k < kMaxProjectiles; ++k) {
        shot.position.x += 1;
        solver->fire(shot);
    }
    EXPECT_THROW(solver->fire(shot), UsageError);
    EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
}

}  // namespace
}  // namespace demolish::tests
