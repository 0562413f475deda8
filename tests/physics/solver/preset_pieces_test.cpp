// SPDX-License-Identifier: Apache-2.0
// Bodies that come apart into preset pieces: nothing before the hit, everything at once, and no bond stepped.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sim_cuda/api/errors.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class PresetPiecesTest : public OnEitherDevice {};

/// A brick of 640 cells on the floor; the ball needs 0.108 s to it.
SceneSetup brickAndBall(const PresetPieces& preset, const Double3& way = {10, 0, 0}) {
    SceneSetup setup = freeBody(latticeBody(8, 10, 8, 0.03, 0.2));
    setup.bodies[0].material.critical_velocity = 2;
    setup.bodies[0].material.tough_cells = 12;
    Projectile ball;
    ball.radius = 0.05;
    const double before = 0.108, reach = 0.12 + ball.radius;
    const double speed = std::hypot(way.x, way.z);
    ball.position = {-(before + reach / speed) * way.x, 0.18, -(before + reach / speed) * way.z};
    ball.velocity = way;
    setup.projectiles.push_back(ball);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders = {Plane{}};
    setup.params.hand_over = setup.params.sleeping = true;
    setup.params.preset_pieces = preset;
    return setup;
}

std::vector<uint32_t> fragmentsOf(Solver& solver) {
    return exportedFrame(solver, solver.stats().particles).fragments;
}
size_t piecesOf(const std::vector<uint32_t>& fragments) {
    return std::set<uint32_t>(fragments.begin(), fragments.end()).size();
}
void runTo(Solver& solver, double time) {
    while (solver.stats().time < time - 1e-9) ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
}

TEST_F(PresetPiecesTest, NothingBreaksBeforeTheHitAndAllAtOnce) {
    auto solver = makeSolver(brickAndBall({}));
    std::set<uint32_t> counts;
    double broke_at = 0;
    for (int frame = 0; frame < 60; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        const FrameStats& stats = solver->stats();
        EXPECT_EQ(stats.bonded_particles, 0u) << "a bond was stepped in frame " << frame;
        counts.insert(stats.bonds_broken);
        if (broke_at == 0 && stats.bonds_broken > 0) broke_at = stats.time;
    }
    EXPECT_EQ(counts.size(), 2u) << "whole, then one number for good";
    EXPECT_GE(broke_at, 0.108 - 0.004);
    EXPECT_LE(broke_at, 0.108 + 1.0 / 60);
    EXPECT_NEAR(solver->stats().fragments, 12, 4) << "as many as the body has tough cells";
    EXPECT_EQ(piecesOf(fragmentsOf(*solver)), solver->stats().fragments);
}

TEST_F(PresetPiecesTest, PiecesAddUpToTheBody) {
    auto solver = makeSolver(brickAndBall({Pattern::kBricks, false}));
    runTo(*solver, 0.3);
    const std::vector<uint32_t> fragments = fragmentsOf(*solver);
    ASSERT_EQ(fragments.size(), 640u);
    std::map<uint32_t, size_t> size;
    for (const uint32_t slot : fragments) ++size[slot];
    size_t sum = 0, largest = 0;
    for (const auto& [slot, cells] : size) {
        sum += cells;
        largest = std::max(largest, cells);
    }
    EXPECT_EQ(sum, 640u);
    EXPECT_NEAR(solver->stats().largest_fragment_fraction, double(largest) / 640, 1e-3);
}

TEST_F(PresetPiecesTest, WhatIsSlowerThanTheThresholdReleasesNothing) {
    SceneSetup setup = brickAndBall({});
    setup.bodies[0].material.critical_velocity = 100;
    auto solver = makeSolver(setup);
    runTo(*solver, 0.4);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_EQ(solver->stats().fragments, 1u);
    EXPECT_EQ(solver->stats().bonded_particles, 0u);
}

TEST_F(PresetPiecesTest, ABallThatPassesByReleasesNothing) {
    SceneSetup setup = brickAndBall({});
    setup.projectiles[0].position.z = 0.12 + 0.05 + 0.03;
    auto solver = makeSolver(setup);
    runTo(*solver, 0.3);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
}

TEST_F(PresetPiecesTest, OnlyAPatternAtTheImpactFollowsTheImpact) {
    const auto brokenFrom = [](bool at_impact, const Double3& way) {
        auto solver = makeSolver(brickAndBall({Pattern::kRadial, at_impact}, way));
        runTo(*solver, 0.2);
        return fragmentsOf(*solver);
    };
    const Double3 left{10, 0, 0}, front{0, 0, 10};
    EXPECT_EQ(brokenFrom(false, left), brokenFrom(false, front));
    EXPECT_NE(brokenFrom(true, left), brokenFrom(true, front));
}

TEST_F(PresetPiecesTest, ADroppedBodyComesApartOnTheFloor) {
    SceneSetup setup = brickAndBall({});
    setup.projectiles.clear();
    setup.bodies[0].position.y = 0.2;
    setup.bodies[0].velocity = {0, -4, 0};
    auto solver = makeSolver(setup);
    runTo(*solver, 1.0 / 60);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    runTo(*solver, 0.1);
    EXPECT_GT(solver->stats().fragments, 5u);
}

TEST_F(PresetPiecesTest, EachBodyComesApartWhenItIsHit) {
    SceneSetup setup = brickAndBall({});
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {0, 0, 1};
    auto solver = makeSolver(setup);
    runTo(*solver, 0.2);
    const std::vector<uint32_t> fragments = fragmentsOf(*solver);
    EXPECT_GT(piecesOf({fragments.begin(), fragments.begin() + 640}), 5u);
    EXPECT_EQ(piecesOf({fragments.begin() + 640, fragments.end()}), 1u);
}

TEST_F(PresetPiecesTest, TheBooksCloseAndMomentumIsKept) {
    SceneSetup setup = brickAndBall({Pattern::kUniform, true});
    setup.params.gravity = {};
    setup.params.colliders.clear();
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), scale = solver->stats().energy.kinetic;
    const Double3 momentum = solver->stats().linear_momentum;
    runTo(*solver, 0.3);
    solver->measure();
    EXPECT_GT(solver->stats().fragments, 5u);
    EXPECT_EQ(solver->stats().energy.fracture, 0) << "a pattern takes no work to break";
    EXPECT_NEAR(energySum(solver->stats().energy), before, 0.01 * scale);
    EXPECT_NEAR(solver->stats().linear_momentum.x, momentum.x, 1e-4 * momentum.x);
}

TEST_F(PresetPiecesTest, ASnapshotGoesOnToTheSameBits) {
    const SceneSetup setup = brickAndBall({Pattern::kSplinters, true});
    auto solver = makeSolver(setup), other = makeSolver(setup);
    runTo(*solver, 0.15);
    other->restore(solver->save());
    runTo(*solver, 0.3);
    runTo(*other, 0.3);
    EXPECT_EQ(other->stateHash(), solver->stateHash());
    const Snapshot broken = solver->save();
    auto third = makeSolver(setup);
    const Snapshot start = third->save();
    third->restore(broken);
    third->restore(start);
    runTo(*third, 0.3);
    EXPECT_EQ(third->stateHash(), solver->stateHash());
}

TEST_F(PresetPiecesTest, AFrameThatIsGivenUpLeavesTheBodyWhole) {
    auto solver = makeSolver(brickAndBall({})), alone = makeSolver(brickAndBall({}));
    while (solver->stats().bonds_broken == 0) {
        ASSERT_LT(solver->stats().time, 0.2);
        // All but the last stretch of the frame, then from its start once more.
        ASSERT_EQ(solver->advanceFrame(1, [](double share) { return share < 0.7; }), StepStatus::kOk);
        solver->giveUpFrame();
        EXPECT_EQ(solver->stateHash(), alone->stateHash());
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(alone->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(solver->stateHash(), alone->stateHash());
        EXPECT_EQ(solver->stats().fragments, alone->stats().fragments);
    }
}

TEST_F(PresetPiecesTest, TheSameForAnyNumberOfThreadsAndWhoeverWatches) {
    const auto hashOf = [](size_t threads, bool watched) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        SceneSetup setup = brickAndBall({Pattern::kRadial, true});
        setup.params.ledger = watched;
        auto solver = makeSolver(setup);
        while (solver->stats().time < 0.3) {
            EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
            if (!watched) continue;
            solver->measure();
            fragmentsOf(*solver);
        }
        return solver->stateHash();
    };
    const uint64_t alone = hashOf(1, false);
    EXPECT_EQ(hashOf(2, false), alone);
    EXPECT_EQ(hashOf(2, true), alone);
}

TEST_F(PresetPiecesTest, AreRefusedWithoutHandOver) {
    SceneSetup setup = brickAndBall({});
    setup.params.hand_over = false;
    EXPECT_THROW(makeSolver(setup), UsageError);
}

}  // namespace
}  // namespace demolish::tests
