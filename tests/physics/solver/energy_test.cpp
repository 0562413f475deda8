// SPDX-License-Identifier: Apache-2.0
// The ledger closes: what an impact brings in is found again as motion, heat and broken bonds (physics.md D
// 20).
#include <algorithm>
#include <cmath>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Energy : public OnEitherDevice {};

SceneSetup drop(double safety, uint32_t substeps) {
    SceneSetup setup = freeBody(latticeBody(6, 6, 6, 0.05, 0.2));
    setup.bodies[0].position = {0, 0.12, 0};
    setup.bodies[0].rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    setup.bodies[0].velocity = {0, -3, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {0, -9.81, 0};
    setup.params.step_safety = safety;
    setup.params.substeps = substeps;
    return setup;
}

/// Surplus over the energy of the impact after `frames`.
double surplus(const SceneSetup& setup, int frames, double& broken) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), impact = solver->stats().energy.kinetic;
    for (int frame = 0; frame < frames; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const FrameStats& stats = solver->stats();
    EXPECT_GE(stats.energy.damping, 0);
    EXPECT_GE(stats.energy.friction, 0);
    EXPECT_GE(stats.energy.fracture, 0);
    broken = static_cast<double>(stats.bonds_broken) / stats.bonds;
    return (energySum(stats.energy) - before) / impact;
}

TEST_F(Energy, TheLedgerClosesThroughAnImpact) {
    double broken = 0;
    EXPECT_LT(std::abs(surplus(drop(0.5, 200), 4, broken)), 0.01);
    EXPECT_GT(broken, 0.1);
}

/// Were they as stiff as their steps would bear, they would lie on less than a last digit of their size.
TEST_F(Energy, TheLedgerClosesForCellsOfTwentyMetres) {
    SceneSetup setup = freeBody(latticeBody(1, 2, 1, 20));
    setup.bodies[0].position = {0, 0.1, 0};
    setup.bodies[0].rotation = {0, 0, 0.008, 0.99997};
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 422;
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), height = solver->stats().energy.potential;
    for (int frame = 0; frame < 60; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const double fallen = height - solver->stats().energy.potential;
    EXPECT_GT(fallen, 0.03 * 9.81 * solver->stats().mass) << "it has landed";
    EXPECT_NEAR(energySum(solver->stats().energy), before, 0.01 * fallen);
}

/// By its velocity it comes from inside the body, and no step has seen the two touch.
TEST_F(Energy, ABallThatStartsBesideABodyHasTouchedNothing) {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.05));
    setup.params.substeps = 200;
    Projectile ball;
    ball.radius = 0.05;
    ball.position = {0.1504, 0.025, 0.025};  // 0.4 mm off the nearest cell
    ball.velocity = {60, 0, 0};              // 5 mm in a step
    setup.projectiles = {ball};
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 2; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_GT(solver->stats().energy.kinetic, 1000);
    EXPECT_NEAR(solver->stats().energy.damping, 0, 1e-6);
}

/// Mean error of drops that differ a little, at a step so many times finer and the same wave speed. One drop
/// alone tells little: two thirds of its bonds break, and other ones at every step.
double meanError(uint32_t finer) {
    constexpr int kDrops = 8;
    double total = 0, broken = 0;
    for (int k = 0; k < kDrops; ++k) {
        SceneSetup setup = drop(0.5 / finer, 200 * finer);
        setup.bodies[0].velocity.x = 0.1 * k;
        total += std::abs(surplus(setup, 4, broken));
    }
    return total / kDrops;
}

TEST_F(Energy, TheErrorIsSmallAtEveryStep) {
    for (const uint32_t finer : {1, 2, 4}) EXPECT_LT(meanError(finer), 5e-4) << finer;
}

/// A contact as stiff as the step allows, met at every part of a step: what its first and its last step take
/// and give beyond the spring is 3 % of the impact at most, and booked.
TEST_F(Energy, TheFirstAndTheLastStepOfAContactAreBooked) {
    for (const double restitution : {0.9, 0.5, 0.1})
        for (int part = 0; part < 8; ++part) {
            SceneSetup setup = freeBody(ballBody(0.05));
            setup.bodies[0].material.restitution = restitution;
            setup.params.colliders.push_back(Plane{});
            setup.params.substeps = 200;
            setup.bodies[0].velocity = {0, -3, 0};
            setup.bodies[0].position = {0, 0.004 + 3 * part / (8 * 60.0 * setup.params.substeps), 0};
            auto solver = makeSolver(setup);
            solver->measure();
            const double before = solver->stats().energy.kinetic;
            for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            solver->measure();
            EXPECT_LT(solver->stats().energy.kinetic, 0.95 * before) << "it has hit";
            EXPECT_LT(std::abs(energySum(solver->stats().energy) - before) / before, 1e-3)
                << restitution << ", " << part;
        }
}

/// Farthest that the sum strays within `steps` substeps from what it is at first, over the kinetic energy
/// then.
double straying(Solver& solver, int steps) {
    solver.measure();
    const double before = energySum(solver.stats().energy), impact = solver.stats().energy.kinetic;
    double farthest = 0;
    for (int step = 0; step < steps; ++step) {
        EXPECT_EQ(solver.advanceSubsteps(1), StepStatus::kOk);
        solver.measure();
        farthest = std::max(farthest, std::abs(energySum(solver.stats().energy) - before));
    }
    return farthest / impact;
}

/// A strong damper takes a sixth of the energy in one substep. What the half of it takes that is over when
/// the energy is measured is in the books too.
TEST_F(Energy, IsFoundInEveryMomentOfAHit) {
    SceneSetup setup = freeBody(ballBody(0.05));
    setup.bodies[0].material.restitution = 0.1;
    setup.bodies[0].velocity = {0.5, -3, 0};
    setup.bodies[0].position = {0, 0.004, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 200;
    auto solver = makeSolver(setup);
    EXPECT_LT(straying(*solver, 60), 1e-4);
    EXPECT_GT(solver->stats().energy.damping, 0);
}

/// Bonds that break while contacts push their ends hard, so that the velocities change much in a kick.
TEST_F(Energy, OfBondsThatBreakInAHardHitIsFound) {
    SceneSetup setup = drop(0.5, 100);
    setup.bodies[0].velocity = {0, -60, 0};
    auto solver = makeSolver(setup);
    EXPECT_LT(straying(*solver, 100), 1e-3);
    EXPECT_GT(solver->stats().bonds_broken, solver->stats().bonds / 2);
}

/// A window opens the books when somebody wants to see them, and closes them again: the run is the same to
/// the last bit, and from there on everything is found again.
TEST_F(Energy, BooksThatAreOpenedDuringTheRunCloseFromThenOn) {
    SceneSetup setup = drop(0.5, 200);
    setup.params.hand_over = setup.params.sleeping = true;
    auto booked = makeSolver(setup);
    setup.params.ledger = false;
    auto solver = makeSolver(setup);
    const auto advance = [&](int frames) {
        for (int frame = 0; frame < frames; ++frame) {
            ASSERT_EQ(booked->advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(solver->stateHash(), booked->stateHash());
        }
    };
    solver->measure();
    const double impact = solver->stats().energy.kinetic;
    advance(2);
    EXPECT_GT(booked->stats().energy.damping, 0);
    EXPECT_EQ(solver->stats().energy.damping + solver->stats().energy.friction, 0);
    solver->bookEnergy(true);
    solver->measure();
    const EnergyLedger opened = solver->stats().energy;
    const uint32_t broken = solver->stats().bonds_broken;
    advance(3);
    solver->measure();
    const EnergyLedger seen = solver->stats().energy;
    EXPECT_GT(solver->stats().bonds_broken, broken);
    EXPECT_GT(seen.damping, 0);
    EXPECT_GT(seen.fracture, 0);
    EXPECT_LT(std::abs(energySum(seen) - energySum(opened)) / impact, 0.01);
    advance(1);
    const double closed = solver->stats().energy.damping;
    solver->bookEnergy(false);
    advance(1);
    EXPECT_EQ(solver->stats().energy.damping, closed);
    EXPECT_GT(booked->stats().energy.damping, closed);
}

TEST_F(Energy, AShotFiredDuringTheRunIsExternalWork) {
    SceneSetup setup = drop(0.5, 200);
    setup.bodies[0].velocity = {};
    setup.params.gravity = {};
    auto solver = makeSolver(setup);
    ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const double before = energySum(solver->stats().energy);
    Projectile ball;
    ball.radius = 0.05;
    ball.position = {-0.5, 0.2, 0};
    ball.velocity = {20, 0, 0};
    solver->fire(ball);
    const double energy = 0.5 * 7800 * 4.0 / 3 * 3.141592653589793 * 0.000125 * 400;
    for (int frame = 0; frame < 3; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_NEAR(solver->stats().energy.external, energy, 1e-6 * energy);
    EXPECT_GT(solver->stats().bonds_broken, 0u);
    EXPECT_LT(std::abs(energySum(solver->stats().energy) - before) / energy, 0.03);
}

}  // namespace
}  // namespace demolish::tests
