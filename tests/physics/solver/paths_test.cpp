// SPDX-License-Identifier: Apache-2.0
// What a path leads: it goes where its keys say, hits with its speed, and its work is in the books.
#include <tbb/global_control.h>

#include <cmath>
#include <vector>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Paths : public OnEitherDevice {};
class PathsOnTheCpu : public OnTheCpu {};

constexpr Regimes kAllRegimes[] = {{false, false}, {false, true}, {true, true}};

/// Leads all of a body, about its own origin.
Anchor leading(const SceneSetup& setup, uint32_t body, MotionPath path) {
    Anchor anchor;
    anchor.body = body;
    anchor.path = std::move(path);
    anchor.pivot = setup.bodies[body].position;
    return anchor;
}

void advance(Solver& solver, int frames) {
    for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
}

/// A ball at rest, and one as heavy that a path leads against it at 2 m/s.
SceneSetup ballHit(double restitution) {
    constexpr double kRadius = 0.05;
    SceneSetup setup = freeBody(ballBody(kRadius));
    setup.bodies[0].material.restitution = restitution;
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {-3 * kRadius, 0, 0};
    setup.anchors.push_back(leading(setup, 1, {{{0.5, {1, 0, 0}, {}}}, false}));
    return setup;
}

TEST_F(Paths, ABallHitByWhatIsLedLeavesWithItsSpeedAndTheRestitution) {
    for (const double restitution : {0.2, 0.6})
        for (const Regimes regimes : kAllRegimes) {
            auto solver = makeSolver(with(ballHit(restitution), regimes));
            advance(*solver, 18);
            solver->measure();
            // What is led counts neither as moving nor as heavy.
            const double mass = 0.5 * solver->stats().mass, speed = solver->stats().linear_momentum.x / mass;
            EXPECT_NEAR(speed, (1 + restitution) * 2, 0.03 * speed)
                << "e = " << restitution << (regimes.hand_over ? ", rigid" : "");
            const EnergyLedger& energy = solver->stats().energy;
            EXPECT_NEAR(energySum(energy), 0, 0.01 * energy.external);
            EXPECT_NEAR(energy.external, mass * speed * 2, 0.03 * energy.external);  // F dt v
        }
}

constexpr double kEdge = 0.05, kWay = 0.6, kFriction = 0.4;
constexpr uint32_t kPushed = 5 * 2 * 4;

/// A block on the floor, and one beside it that a path leads on. It ends at rest.
SceneSetup pushedBlock() {
    SceneSetup setup = freeBody(latticeBody(5, 2, 4, kEdge));
    setup.bodies[0].material.critical_velocity = 50;
    setup.bodies[0].material.friction = 0;  // of the floor alone: the pusher bears no weight
    setup.params.gravity = {0, -9.81, 0};
    Collider floor = Plane{};
    floor.friction = kFriction;
    setup.params.colliders.push_back(floor);
    setup.params.substeps = 100;
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].body = latticeBody(2, 2, 4, kEdge);
    setup.bodies[1].material.critical_velocity = 1e6;
    setup.bodies[1].position = {-3.55 * kEdge, 0, 0};
    setup.anchors.push_back(leading(setup, 1, {{{0.1, {}, {}}, {1.6, {kWay, 0, 0}, {}}}, true}));
    return setup;
}

TEST_F(Paths, ABlockPushedAlongTheFloorTakesMuMgTimesItsWay) {
    for (const Regimes regimes : kAllRegimes) {
        SceneSetup setup = pushedBlock();
        auto solver = makeSolver(with(setup, regimes));
        solver->measure();
        const double start = energySum(solver->stats().energy);
        const double mass = setup.bodies[0].material.density * kPushed * kEdge * kEdge * kEdge;
        const auto before = exportedFrame(*solver, kPushed).particles;
        advance(*solver, 120);
        solver->measure();
        const auto after = exportedFrame(*solver, kPushed).particles;
        const double way = after[0].position.x - before[0].position.x,
                     expected = kFriction * mass * 9.81 * way;
        const EnergyLedger& energy = solver->stats().energy;
        EXPECT_NEAR(way, kWay, 0.05 * kWay);
        EXPECT_NEAR(energy.external, expected, 0.03 * expected) << (regimes.hand_over ? "rigid" : "bonded");
        EXPECT_NEAR(energy.friction, expected, 0.05 * expected);
        EXPECT_NEAR(energySum(energy), start, 0.02 * expected);
        EXPECT_EQ(solver->stats().bonds_broken, 0u);
        EXPECT_TRUE(!regimes.sleeping || solver->stats().awake_particles == 0);
    }
}

/// A brick that goes and turns, alone.
SceneSetup turningBrick() {
    SceneSetup setup = freeBody(latticeBody(4, 2, 2, kEdge));
    setup.bodies[0].material.critical_velocity = 1e6;
    setup.params.substeps = 100;
    setup.params.gravity = {0, -9.81, 0};
    setup.anchors.push_back(
        leading(setup, 0, {{{0.5, {0, 0, 0}, {}}, {0.9, {0.4, 0.2, -0.1}, {0, 0, M_PI / 2}}}, true}));
    return setup;
}

TEST_F(Paths, WhatIsLedEndsWhereItsLastKeySaysAndSleeps) {
    for (const Regimes regimes : kAllRegimes) {
        auto solver = makeSolver(with(turningBrick(), regimes));
        const auto before = exportedFrame(*solver, 16).particles;
        advance(*solver, 25);
        EXPECT_TRUE(!regimes.sleeping || solver->stats().awake_particles == 0);
        const auto waiting = exportedFrame(*solver, 16).particles;
        for (size_t i = 0; i < before.size(); ++i) EXPECT_EQ(waiting[i].position.x, before[i].position.x);
        advance(*solver, 60);
        const auto after = exportedFrame(*solver, 16).particles;
        for (size_t i = 0; i < before.size(); ++i) {  // a quarter of a turn about z
            EXPECT_NEAR(after[i].position.x, 0.4 - before[i].position.y, 2e-6);
            EXPECT_NEAR(after[i].position.y, 0.2 + before[i].position.x, 2e-6);
            EXPECT_NEAR(after[i].position.z, before[i].position.z - 0.1, 2e-6);
        }
        EXPECT_EQ(solver->stats().bonds_broken, 0u);
        EXPECT_TRUE(!regimes.sleeping || solver->stats().awake_particles == 0);
    }
}

/// A plank whose end is held by a wall that moves up: the free end follows, and the weight is lifted.
SceneSetup liftedPlank() {
    SceneSetup setup = freeBody(latticeBody(8, 2, 2, kEdge));
    setup.bodies[0].material.critical_velocity = 100;
    setup.params.substeps = 100;
    setup.params.gravity = {0, -9.81, 0};
    setup.params.settle_time = 0.5;
    Anchor wall;
    wall.region = Box{{kEdge, 1, 1}, {-4.3 * kEdge, 0, 0}, {}};
    wall.path = {{{0.2, {}, {}}, {1.2, {0, 0.3, 0}, {}}}, true};
    setup.anchors.push_back(wall);
    return setup;
}

TEST_F(Paths, AWallThatMovesLiftsWhatIsBuiltIntoIt) {
    for (const Regimes regimes : kAllRegimes) {
        auto solver = makeSolver(with(liftedPlank(), regimes));
        const auto before = exportedFrame(*solver, 32).particles;
        solver->measure();
        const double start = energySum(solver->stats().energy);
        advance(*solver, 120);
        solver->measure();
        const auto after = exportedFrame(*solver, 32).particles;
        const double free_mass = solver->stats().mass * 7 / 8, lifted = free_mass * 9.81 * 0.3;
        EXPECT_NEAR(solver->stats().energy.external, lifted, 0.02 * lifted);
        EXPECT_NEAR(energySum(solver->stats().energy), start, 0.01 * lifted);
        EXPECT_NEAR(after[0].position.y, before[0].position.y + 0.3, 2e-6);
        EXPECT_NEAR(after[7].position.y, before[7].position.y + 0.3, 1e-3);  // it still swings
        EXPECT_TRUE(!regimes.hand_over || solver->stats().awake_particles == 0);
    }
}

/// A hammer that swings through a brick.
SceneSetup hammer() {
    SceneSetup setup = freeBody(latticeBody(4, 6, 4, kEdge));
    setup.bodies[0].material.tough_cells = 0;
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 150;
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].body = latticeBody(2, 2, 2, kEdge);
    setup.bodies[1].material.critical_velocity = 1e6;
    setup.bodies[1].position = {-0.4, 0.15, 0};
    setup.anchors.push_back(leading(setup, 1, {{{0.2, {}, {}}, {0.3, {0.6, 0, 0}, {0, 0, -1}}}, false}));
    return setup;
}

TEST_F(Paths, AHammerBreaksWhatItHitsAndTheBooksClose) {
    auto solver = makeSolver(with(hammer(), {true, true}));
    solver->measure();
    const double start = energySum(solver->stats().energy);
    advance(*solver, 40);
    solver->measure();
    const EnergyLedger& energy = solver->stats().energy;
    EXPECT_GT(solver->stats().bonds_broken, 30u);
    EXPECT_GT(energy.external, 1);
    EXPECT_NEAR(energySum(energy), start, 0.02 * energy.external);
}

/// It stands in what is anchored when its path begins, with a speed that jumps, and goes through it.
TEST_F(Paths, WhatIsLedThroughWhatIsAnchoredBooksNothing) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, kEdge));
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {1.9 * kEdge, 0.3 * kEdge, 0};
    setup.params.substeps = 100;
    setup.anchors.push_back(leading(setup, 0, {}));
    setup.anchors.push_back(leading(setup, 1, {{{0.1, {}, {}}, {0.3, {-0.5, 0, 0.1}, {}}}, false}));
    for (const Regimes regimes : kAllRegimes) {
        auto solver = makeSolver(with(setup, regimes));
        solver->measure();
        const double before = energySum(solver->stats().energy);
        for (int frame = 0; frame < 24; ++frame) {
            ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
            solver->measure();
            const EnergyLedger& energy = solver->stats().energy;
            EXPECT_NEAR(energy.damping, 0, 1e-6) << frame;  // J
            EXPECT_NEAR(energySum(energy), before, 1e-6) << frame;
        }
    }
}

/// A block stands on a plate that begins to rise at full speed: in the kick of that moment the plate bears
/// its weight at the speed before and after.
TEST_F(Paths, WhatBeginsAtFullSpeedIsBookedByBothSpeeds) {
    constexpr double kSpeed = 0.1, kStart = 0.1;
    for (const Regimes regimes : kAllRegimes) {
        SceneSetup setup = freeBody(latticeBody(4, 4, 4, kEdge));
        setup.bodies[0].material.critical_velocity = 50;
        setup.bodies[0].position = {0, kEdge, 0};
        setup.bodies.push_back(setup.bodies[0]);
        setup.bodies[1].body = latticeBody(6, 1, 6, kEdge);
        setup.bodies[1].position = {0, 0, 0};
        setup.params.gravity = {0, -9.81, 0};
        setup.params.settle_time = 0.3;
        setup.params.substeps = 40;
        setup.anchors.push_back(
            leading(setup, 1, {{{kStart, {}, {}}, {kStart + 1, {0, kSpeed, 0}, {}}}, false}));
        auto solver = makeSolver(with(setup, regimes));
        advance(*solver, 6);
        solver->measure();
        const double mass = setup.bodies[0].material.density * 64 * kEdge * kEdge * kEdge,
                     start = energySum(solver->stats().energy);
        EXPECT_NEAR(solver->stats().energy.external, 0, 1e-3 * mass * kSpeed * kSpeed);
        ASSERT_EQ(solver->advanceSubsteps(10), StepStatus::kOk);
        solver->measure();
        const double begun = energySum(solver->stats().energy);
        advance(*solver, 3);
        solver->measure();
        EXPECT_GT(solver->stats().energy.external, mass * kSpeed * kSpeed);
        EXPECT_NEAR(energySum(solver->stats().energy), begun, 1e-3 * mass * kSpeed * kSpeed)
            << "half of a kick is under way, and what is led has given that, too";
        EXPECT_NEAR(energySum(solver->stats().energy), start, 1e-3 * mass * kSpeed * kSpeed);
    }
}

TEST_F(Paths, ARunGoesOnFromASnapshotToTheSameBits) {
    auto solver = makeSolver(with(hammer(), {true, true}));
    advance(*solver, 15);
    const Snapshot snapshot = solver->save();
    advance(*solver, 10);
    const uint64_t hash = solver->stateHash();
    solver->restore(snapshot);
    advance(*solver, 10);
    EXPECT_EQ(solver->stateHash(), hash);
}

TEST_F(PathsOnTheCpu, TheNumberOfThreadsChangesNoBit) {
    uint64_t hash[2];
    for (const size_t threads : {1u, 2u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        auto solver = makeCpuSolver(with(hammer(), {true, true}));
        advance(*solver, 30);
        hash[threads - 1] = solver->stateHash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

}  // namespace
}  // namespace demolish::tests
