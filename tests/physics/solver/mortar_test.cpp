// SPDX-License-Identifier: Apache-2.0
// Bricks in mortar: a joint bears what its strength says, a wall stands, and its joints break first.
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim_cuda/api/turned_body.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/placed_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class MortarJoints : public OnEitherDevice {};
class MortarOnTheCpu : public OnTheCpu {};

constexpr double kLength = 0.24, kHeight = 0.071, kDepth = 0.115, kGap = 0.0005;  // m, of a brick
constexpr double kShare = 0.25;                                                   // of the bricks' strength

std::shared_ptr<const BreakableBody> brick(uint32_t particles) {
    return filledModel("brick.obj", kHeight, particles);
}

BodyInstance placed(std::shared_ptr<const BreakableBody> body, const Double3& position) {
    BodyInstance instance = placedBody(std::move(body), position);
    instance.material.critical_velocity = 2.5;
    return instance;
}

/// A brick that is held, and one that hangs on it by mortar, in so many times the gravity at which the joint
/// bears as much as its strength.
SceneSetup hangingBrick(double times) {
    SceneSetup setup;
    const auto body = brick(150);
    setup.bodies = {placed(body, {0, kHeight + kGap, 0}), placed(body, {0, 0, 0})};
    setup.params.colliders.clear();
    setup.params.substeps = 200;
    setup.params.settle_time = 0.3;
    const Material& material = setup.bodies[0].material;
    setup.mortar = Mortar{kShare * material.tensile_strength, 0.001};
    Anchor hand;
    hand.body = 0;
    setup.anchors.push_back(hand);
    setup.params.gravity = {};
    const double strength = kShare * makeCpuSolver(setup)->softening().strength;
    setup.params.gravity.y = -times * strength / (material.density * kHeight);
    return setup;
}

TEST_F(MortarJoints, AJointBearsAsMuchAsItsStrength) {
    for (const double times : {0.55, 1.1}) {
        auto solver = makeSolver(hangingBrick(times));
        EXPECT_EQ(solver->stats().fragments, 1u);
        for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(solver->stats().fragments, times < 1 ? 1u : 2u) << times;
        if (times < 1) {
            EXPECT_LT(solver->stats().bonds_broken, 3u);
        }
    }
}

constexpr uint32_t kRows = 6, kInRow = 4, kCells = 24;

/// A wall of 24 bricks in bond.
SceneSetup wall(bool in_mortar) {
    SceneSetup setup;
    const auto body = brick(kCells);
    for (uint32_t row = 0; row < kRows; ++row)
        for (uint32_t k = 0; k < kInRow; ++k)
            setup.bodies.push_back(
                placed(body, {(kLength + kGap) * (k + (row % 2) * 0.5), row * (kHeight + kGap), 0}));
    setup.params.settle_time = 0.2;
    setup.params.substeps = 150;
    if (in_mortar) setup.mortar = Mortar{kShare * setup.bodies[0].material.tensile_strength, 0.001};
    return with(setup, {true, true});
}

Projectile ball(double speed) {
    Projectile shot;
    shot.radius = 0.06;
    shot.position = {0.4, 0.3, 0.4};
    shot.velocity = {0, 0, -speed};
    return shot;
}

/// Bricks of whose cells some hang together no more.
uint32_t brokenBricks(Solver& solver) {
    const auto fragment = exportedFrame(solver, kRows * kInRow * kCells).fragments;
    uint32_t broken = 0;
    for (uint32_t b = 0; b < kRows * kInRow; ++b) {
        const auto first = fragment.begin() + b * kCells;
        broken += std::any_of(first, first + kCells, [&](uint32_t slot) { return slot != *first; }) ? 1 : 0;
    }
    return broken;
}

TEST_F(MortarJoints, AWallStandsForTenSecondsAndSleeps) {
    auto solver = makeSolver(wall(true));
    const auto before = exportedFrame(*solver, kRows * kInRow * kCells).particles;
    for (int frame = 0; frame < 600; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const auto after = exportedFrame(*solver, kRows * kInRow * kCells).particles;
    for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i].position.y, before[i].position.y, 1e-3);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_EQ(solver->stats().fragments, 1u);
    EXPECT_EQ(solver->stats().awake_particles, 0u);
}

TEST_F(MortarJoints, WhereItIsHitTheJointsBreakFirst) {
    SceneSetup setup = wall(true);
    setup.projectiles.push_back(ball(1.5));
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_GT(solver->stats().fragments, 3u);
    EXPECT_LE(brokenBricks(*solver), 2u);
}

TEST_F(MortarJoints, InMortarItHoldsMoreThanDry) {
    uint32_t fragments[2];
    for (const bool in_mortar : {false, true}) {
        SceneSetup setup = wall(in_mortar);
        setup.projectiles.push_back(ball(0.5));
        auto solver = makeSolver(setup);
        EXPECT_EQ(solver->stats().fragments, in_mortar ? 1u : kRows * kInRow);
        for (int frame = 0; frame < 40; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        fragments[in_mortar ? 1 : 0] = solver->stats().fragments;
    }
    EXPECT_EQ(fragments[1], 1u);
}

TEST_F(MortarJoints, MomentumAndEnergyAreKept) {
    SceneSetup setup = wall(true);
    setup.params.colliders.clear();
    setup.params.gravity = {};
    setup.params.settle_time = 0;
    setup.projectiles.push_back(ball(4));
    auto solver = makeSolver(setup);
    solver->measure();
    const Double3 before = solver->stats().linear_momentum;
    const double start = energySum(solver->stats().energy), scale = solver->stats().energy.kinetic;
    for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_GT(solver->stats().bonds_broken, 10u);
    EXPECT_NEAR(solver->stats().linear_momentum.z, before.z, 1e-5 * std::abs(before.z));
    EXPECT_NEAR(energySum(solver->stats().energy), start, 0.02 * scale);
}

TEST_F(MortarOnTheCpu, TheNumberOfThreadsChangesNoBit) {
    uint64_t hash[2];
    for (const size_t threads : {1u, 2u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        SceneSetup setup = wall(true);
        setup.projectiles.push_back(ball(4));
        auto solver = makeCpuSolver(setup);
        for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        hash[threads - 1] = solver->stateHash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

/// Of another material: heavier, and of less than half the strength.
void makeUnlike(BodyInstance& body) {
    body.material.density *= 1.5;
    body.material.critical_velocity *= 0.4;
    body.material.friction = 0.3;
    body.material.shear_ratio = 0.25;
    body.material.damping_ratio = 0.2;
}
/// Of its softened strength beside that of the others, at the modulus that all in mortar share.
const double kUnlikeStrength = 0.4 * std::sqrt(1.5);

/// Does what hangs on the joint hold at `holds` and fall at 1.1 of the weight that the joint bears? `area`:
/// m^2.
void expectBears(SceneSetup setup, double strength, double area, double holds = 0.55) {
    const Material& material = setup.bodies[1].material;
    for (const double times : {holds, 1.1}) {
        setup.params.gravity.y = -times * strength * area / (material.density * kLength * kHeight * kDepth);
        auto solver = makeCpuSolver(setup);
        EXPECT_EQ(solver->stats().fragments, 1u);
        for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(solver->stats().fragments, times < 1 ? 1u : 2u) << times;
    }
}

TEST_F(MortarOnTheCpu, AJointOfUnlikeMaterialsBearsWhatItsWeakerSideSays) {
    SceneSetup setup = hangingBrick(0);
    makeUnlike(setup.bodies[1]);
    const double strength = kShare * kUnlikeStrength * makeCpuSolver(setup)->softening().strength;
    expectBears(setup, strength, kLength * kDepth);
}

TEST_F(MortarOnTheCpu, AJointOfCellsOfUnlikeSizesBearsAsMuch) {
    SceneSetup setup = hangingBrick(0);
    setup.bodies[1].body = brick(60);
    const double strength = kShare * makeCpuSolver(setup)->softening().strength;
    expectBears(setup, strength, kLength * kDepth);
}

/// By half a turn, and across the one above it: there its ends hang over, and the joint's rim bears several
/// times the mean.
TEST_F(MortarOnTheCpu, AJointOfBodiesThatAreTurnedInTheirFramesBearsByItsArea) {
    const double root = std::sqrt(0.5);
    for (const Quaternion turn : {Quaternion{0, 1, 0, 0}, Quaternion{0, root, 0, root}}) {
        SceneSetup setup = hangingBrick(0);
        setup.bodies[1].rotation = turn;
        EXPECT_EQ(makeCpuSolver(setup)->stats().fragments, 2u) << "no orientation in common";
        setup.bodies[1].body = turnedBody(*setup.bodies[1].body, turn);
        setup.bodies[1].rotation = {};
        const double strength = kShare * makeCpuSolver(setup)->softening().strength;
        const bool crosses = turn.w != 0;
        expectBears(setup, strength, (crosses ? kDepth : kLength) * kDepth, crosses ? 0.2 : 0.55);
    }
}

TEST_F(MortarJoints, OfUnlikeMaterialsMomentumAndEnergyAreKept) {
    SceneSetup setup = wall(true);
    for (size_t b = 0; b < setup.bodies.size(); b += 2) makeUnlike(setup.bodies[b]);
    setup.params.colliders.clear();
    setup.params.gravity = {};
    setup.params.settle_time = 0;
    setup.projectiles.push_back(ball(4));
    auto solver = makeSolver(setup);
    EXPECT_EQ(solver->stats().fragments, 1u);
    solver->measure();
    const Double3 before = solver->stats().linear_momentum;
    const double start = energySum(solver->stats().energy), scale = solver->stats().energy.kinetic;
    for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_GT(solver->stats().bonds_broken, 10u);
    EXPECT_NEAR(solver->stats().linear_momentum.z, before.z, 1e-5 * std::abs(before.z));
    EXPECT_NEAR(energySum(solver->stats().energy), start, 0.02 * scale);
}

TEST_F(MortarOnTheCpu, WhatIsNotInMortarOnlyTouches) {
    SceneSetup setup = wall(true);
    setup.bodies.back().in_mortar = false;
    EXPECT_EQ(makeCpuSolver(setup)->stats().fragments, 2u);
}

}  // namespace
}  // namespace demolish::tests
