// SPDX-License-Identifier: Apache-2.0
// Fragments that are handed over in the middle of a hit: what their contacts lose as they become softer is in
// the books, and no more (architecture 9).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class HardHit : public OnEitherDevice {};

/// A cell meets the floor after `arrives` s. Its hit lasts for a few substeps; nothing swings in it, and
/// after 20 ms it is handed over, be it in the middle of that. A column beside it has landed 10 ms before and
/// swings, so that substeps carry the cell on from then.
SceneSetup cellBesideAColumn(double arrives) {
    constexpr double kSpeed = 5;
    SceneSetup setup = with(freeBody(ballBody(0.05)), {true, false});
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 50;
    setup.params.frame_time = 10.0 / (60 * setup.params.substeps);
    BodyInstance& cell = setup.bodies[0];
    cell.material.restitution = 0.9;
    cell.velocity = {0, -kSpeed, 0};
    cell.position = {0, kSpeed * arrives, 0};
    BodyInstance column = cell;
    column.body = latticeBody(1, 2, 1, 0.1);
    column.position = {0.105, kSpeed * (arrives - 0.01), 0};
    setup.bodies.push_back(column);
    return setup;
}

/// Two cells meet in the air after `arrives` s, and both are handed over after 20 ms.
SceneSetup twoCells(double arrives) {
    constexpr double kSpeed = 5;
    SceneSetup setup = cellBesideAColumn(arrives);
    setup.params.colliders.clear();
    setup.bodies[1] = setup.bodies[0];
    setup.bodies[0].position = setup.bodies[0].velocity = {};
    setup.bodies[1].position = {0, kSpeed * arrives + 0.1, 0};
    return setup;
}

/// The energy in the end is that of the start, and something was held by contacts at the hand-over.
void expectClosedBooks(const SceneSetup& setup) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), impact = solver->stats().energy.kinetic;
    double held = 0, held_at_hand_over = 0;
    for (int frame = 0; frame < 30; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        if (solver->stats().rigid_fragments > 0 && held_at_hand_over == 0) held_at_hand_over = held;
        solver->measure();
        held = solver->stats().energy.elastic;
    }
    EXPECT_GT(held_at_hand_over, 0.01 * impact);
    EXPECT_NEAR(energySum(solver->stats().energy), before, 2e-3 * impact);
}

TEST_F(HardHit, LosesAtTheHandOverWhatContactsHeldAndNoMore) {
    for (const double arrives : {0.0176, 0.018, 0.0184, 0.0188, 0.0192}) {
        SCOPED_TRACE(arrives);
        expectClosedBooks(cellBesideAColumn(arrives));
        expectClosedBooks(twoCells(arrives));
    }
}

/// And so in every frame on the way, to `share` of the impact; what is rigid holds a part of it meanwhile.
void expectClosedBooksInEveryMoment(const SceneSetup& setup, int frames, double share) {
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), impact = solver->stats().energy.kinetic;
    double most_held = 0;
    for (int frame = 0; frame < frames; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const EnergyLedger& energy = solver->stats().energy;
        if (solver->stats().rigid_fragments > 0) most_held = std::max(most_held, energy.elastic);
        EXPECT_NEAR(energySum(energy), before, share * impact) << frame;
    }
    EXPECT_GT(most_held, 0.1 * impact);
}

/// A cell that has become rigid lands and slides in contact steps: kinetic energy counts the velocities
/// before and after the kick, and what half of the kick dissipates is booked.
TEST_F(HardHit, InContactStepsIsFoundInEveryMoment) {
    SceneSetup setup = cellBesideAColumn(0.05);
    setup.bodies.resize(1);
    setup.bodies[0].velocity.x = 2;
    setup.params.gravity = {0, -9.81, 0};
    expectClosedBooksInEveryMoment(setup, 40, 1e-4);
}

/// In frames of one substep a fragment's share of mass makes contacts stiffer than a particle alone could
/// bear: they hold as much as they push with.
TEST_F(HardHit, InContactStepsOfOneSubstepIsFoundInEveryMoment) {
    for (const SceneSetup& of_one : {cellBesideAColumn(0.05), twoCells(0.05)}) {
        SceneSetup setup = of_one;
        if (!setup.params.colliders.empty()) setup.bodies.resize(1);
        for (BodyInstance& body : setup.bodies) body.body = latticeBody(2, 2, 2, 0.1);
        if (setup.bodies.size() > 1) setup.bodies[1].position.y += 0.1;
        setup.params.frame_time = 1.0 / (60 * setup.params.substeps);
        expectClosedBooksInEveryMoment(setup, 240, 1e-3);
    }
}

/// A piece of three cells that lands aslant turns by much within a contact step: what its kick dissipates
/// goes by the arms and the spin before that turn.
TEST_F(HardHit, InContactStepsIsFoundHoweverThePieceTurns) {
    for (const double slant : {0.3, 0.6, 0.9, 1.2}) {
        SCOPED_TRACE(slant);
        SceneSetup setup = cellBesideAColumn(0.05);
        setup.bodies.resize(1);
        BodyInstance& piece = setup.bodies[0];
        piece.body = latticeBody(1, 3, 1, 0.1);
        piece.material.restitution = 0.1;
        piece.velocity.y *= 2;
        piece.position.y = 0.5;
        piece.rotation = {0, 0, std::sin(0.5 * slant), std::cos(0.5 * slant)};
        auto solver = makeSolver(setup);
        solver->measure();
        const double before = energySum(solver->stats().energy);
        for (int frame = 0; frame < 40; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        EXPECT_EQ(solver->stats().rigid_fragments, 1u);
        EXPECT_GT(solver->stats().energy.damping, 0.1 * before) << "it has landed";
        EXPECT_NEAR(energySum(solver->stats().energy), before, 1e-3 * before);
    }
}

/// Bodies settle with their bonds, so that the first contact step comes after a substep, and pushes for as
/// long as that says. What the softer contacts let sink is damped.
TEST_F(HardHit, IsNotWhatAColumnFeelsThatIsHandedOverAfterItHasSettled) {
    for (const uint32_t substeps : {1u, 2u, 5u, 10u, 20u}) {
        SCOPED_TRACE(substeps);
        SceneSetup setup = with(freeBody(latticeBody(1, 2, 1, 0.1)), {true, false});
        setup.params.gravity = {0, -9.81, 0};
        setup.params.colliders.push_back(Plane{});
        setup.params.substeps = 40;
        setup.params.settle_time = 0.3;
        setup.params.frame_time = substeps / (60.0 * setup.params.substeps);
        auto solver = makeSolver(setup);
        solver->measure();
        const double before = energySum(solver->stats().energy);
        double damped = 0, time = 0;
        for (const double look : {0.02, 1.0}) {
            for (; time < look; time += setup.params.frame_time)
                ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            solver->measure();
            EXPECT_EQ(solver->stats().rigid_fragments, 1u);
            const EnergyLedger& energy = solver->stats().energy;
            damped = std::max(damped, energy.damping);
            EXPECT_NEAR(energySum(energy), before, 1e-3 * damped) << look;
        }
    }
}

/// Where a contact step is longer than the one before it what presses changes its energy (physics B.1), so
/// that none is much longer than another, however many substeps a frame has.
TEST_F(HardHit, InContactStepsIsFoundWhateverTheSubstepsOfAFrame) {
    for (const uint32_t substeps : {11u, 21u, 23u, 31u, 40u}) {
        for (const double arrives : {0.05, 0.051, 0.052, 0.053, 0.054, 0.055}) {
            SCOPED_TRACE(std::to_string(substeps) + " substeps, after " + std::to_string(arrives));
            SceneSetup setup = cellBesideAColumn(arrives);
            setup.bodies.resize(1);
            setup.bodies[0].body = latticeBody(2, 2, 2, 0.1);
            setup.params.frame_time = substeps / (60.0 * setup.params.substeps);
            auto solver = makeSolver(setup);
            solver->measure();
            const double before = energySum(solver->stats().energy);
            for (double time = 0; time < 0.12; time += setup.params.frame_time)
                ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            solver->measure();
            EXPECT_EQ(solver->stats().rigid_fragments, 1u);
            EXPECT_GT(solver->stats().energy.damping, 0.05 * before) << "it has landed";
            EXPECT_NEAR(energySum(solver->stats().energy), before, 2e-3 * before);
        }
    }
}

/// Two cells that have become rigid stay so in most hits. A ball that comes more than half as far in a
/// contact step as the two are thick would be through them, or round them, before one had seen it a few
/// times.
TEST_F(HardHit, ByABallThatComesFarInAContactStepIsMetInSubsteps) {
    for (const double speed : {15.0, 20.0, 30.0})
        for (int k = 0; k < 10; ++k) {
            const double arrives = 0.05 + 0.00033 * k;
            SCOPED_TRACE(std::to_string(speed) + " m/s after " + std::to_string(arrives) + " s");
            SceneSetup setup = twoCells(1);
            setup.bodies.resize(1);
            setup.bodies[0].body = latticeBody(1, 2, 1, 0.1);
            Projectile ball;
            ball.radius = 0.03;
            ball.position = {0.08 + speed * arrives, 0.06, 0.01};
            ball.velocity = {-speed, 0, 0};
            setup.projectiles = {ball};
            auto solver = makeSolver(setup);
            solver->measure();
            const double before = energySum(solver->stats().energy);
            uint32_t most_rigid = 0;
            for (int frame = 0; frame < 30; ++frame) {
                ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
                most_rigid = std::max(most_rigid, solver->stats().rigid_fragments);
            }
            solver->measure();
            EXPECT_GE(most_rigid, 1u);
            EXPECT_LT(solver->stats().energy.kinetic, 0.95 * before) << "it has been hit";
            EXPECT_NEAR(energySum(solver->stats().energy), before, 5e-3 * before);
        }
}

/// Bodies and lists of a decision are no part of a snapshot: it is made for the measurement.
TEST_F(HardHit, AStatePutBackIsMeasuredInTheMiddleOfAHitAsItWas) {
    SceneSetup setup = cellBesideAColumn(0.05);
    setup.bodies.resize(1);
    setup.bodies[0].body = latticeBody(2, 2, 2, 0.1);
    setup.bodies[0].material.restitution = 0.1;
    auto solver = makeSolver(setup), other = makeSolver(setup);
    double most_taken = 0;
    for (int frame = 0; frame < 40; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        if (frame < 10) continue;
        ASSERT_EQ(solver->stats().rigid_fragments, 1u);
        solver->measure();
        const EnergyLedger now = solver->stats().energy;
        most_taken = std::max(most_taken, now.elastic);
        other->restore(solver->save());
        other->measure();
        EXPECT_NEAR(energySum(other->stats().energy), energySum(now), 1e-4 * 240) << frame;
    }
    EXPECT_GT(most_taken, 1) << "it has landed meanwhile";
}
/// It begins to be rigid by the decision that is made for the measurement, and has not lagged behind before.
TEST_F(HardHit, AStatePutBackIsMeasuredAsItFallsWhenItIsHandedOver) {
    SceneSetup setup = cellBesideAColumn(0.2);
    setup.bodies.resize(1);
    setup.params.gravity = {0, -9.81, 0};
    auto solver = makeSolver(setup), other = makeSolver(setup);
    uint32_t rigid_before = 1;
    bool begins = false;
    for (int frame = 0; frame < 20; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        begins = begins || solver->stats().rigid_fragments > rigid_before;
        rigid_before = solver->stats().rigid_fragments;
        solver->measure();
        const EnergyLedger now = solver->stats().energy;
        other->restore(solver->save());
        other->measure();
        EXPECT_NEAR(energySum(other->stats().energy), energySum(now), 1e-4 * now.kinetic) << frame;
    }
    EXPECT_TRUE(begins);
}
TEST_F(HardHit, AStatePutBackIsMeasuredBeforeAnythingIsDecided) {
    SceneSetup setup = cellBesideAColumn(0.05);
    setup.bodies.resize(1);
    setup.params.gravity = {0, -9.81, 0};
    auto solver = makeSolver(setup), other = makeSolver(setup);
    for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    ASSERT_EQ(solver->stats().rigid_fragments, 1u);
    solver->measure();
    const EnergyLedger falling = solver->stats().energy;
    const Snapshot snapshot = solver->save();
    for (int frame = 0; frame < 6; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    for (Solver* each : {solver.get(), other.get()}) {
        each->restore(snapshot);
        each->measure();
        EXPECT_NEAR(energySum(each->stats().energy), energySum(falling), 1e-3 * falling.kinetic);
    }
}

}  // namespace
}  // namespace demolish::tests
