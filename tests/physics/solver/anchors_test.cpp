// SPDX-License-Identifier: Apache-2.0
// Particles that are held: what is built into a wall sags by beam theory, breaks where it is built in, and
// does not move by a bit where it is held.
#include <tbb/global_control.h>

#include <cmath>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Anchors : public OnEitherDevice {};
class AnchorsOnTheCpu : public OnTheCpu {};

constexpr double kEdge = 0.05;  // m, of a cell
constexpr uint32_t kLinks = 10;

Anchor boxAnchor(const Double3& size, const Double3& position) {
    Anchor anchor;
    anchor.region = Box{size, position, {}};
    return anchor;
}

/// A row of cells along x of which the first is held, in gravity.
SceneSetup cantilever() {
    SceneSetup setup = freeBody(latticeBody(kLinks, 1, 1, kEdge));
    setup.bodies[0].material.critical_velocity = 100;
    setup.params.gravity = {0, -9.81, 0};
    setup.params.settle_time = 1.5;
    setup.anchors.push_back(boxAnchor({kEdge, kEdge, kEdge}, {-0.5 * kEdge * kLinks, 0.5 * kEdge, 0}));
    return setup;
}

/// m, of the last cell: bonds bend by the moment and shear by the force of all that hangs beyond them.
double sagByBeamTheory(const Solver& solver, double mass) {
    const double normal = solver.softening().bond_modulus * kEdge, radius = kEdge / std::sqrt(M_PI);
    const double bending = normal * radius * radius / 4, shear = Material{}.shear_ratio * normal;
    const double weight = 9.81 * mass / kLinks;
    double sag = 0;
    for (uint32_t bond = 0; bond + 1 < kLinks; ++bond) {
        double moment = 0;
        for (uint32_t beyond = bond + 1; beyond < kLinks; ++beyond)
            moment += weight * kEdge * (beyond - bond - 0.5);
        sag += moment / bending * kEdge * (kLinks - 1 - bond - 0.5) + weight * (kLinks - 1 - bond) / shear;
    }
    return sag;
}

bool sameBits(const ParticleInstance& a, const ParticleInstance& b) {
    return a.position.x == b.position.x && a.position.y == b.position.y && a.position.z == b.position.z;
}

TEST_F(Anchors, ABeamBuiltInAtOneEndSagsByBeamTheory) {
    for (const Regimes regimes : {Regimes{false, false}, Regimes{true, true}}) {
        auto solver = makeSolver(with(cantilever(), regimes));
        const auto before = exportedFrame(*solver, kLinks).particles;
        for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        const auto after = exportedFrame(*solver, kLinks).particles;
        const double sag = 0.5 * kEdge - after[kLinks - 1].position.y,
                     expected = sagByBeamTheory(*solver, solver->stats().mass);
        EXPECT_GT(expected, 5e-4);
        EXPECT_NEAR(sag, expected, 0.02 * expected);
        EXPECT_TRUE(sameBits(before[0], after[0]));
        EXPECT_EQ(solver->stats().bonds_broken, 0u);
        EXPECT_EQ(solver->stats().sleeping_fragments, regimes.sleeping ? 1u : 0u);
    }
}

constexpr uint32_t kAcross = 3, kHigh = 12;

/// A column whose lowest cells stand in the ground, and a ball that hits its top.
SceneSetup columnInTheGround(double speed) {
    SceneSetup setup = freeBody(latticeBody(kAcross, kHigh, kAcross, kEdge));
    setup.bodies[0].position = {0, -kEdge, 0};
    setup.bodies[0].material.critical_velocity = 1.5;
    setup.bodies[0].material.tough_cells = 0;
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders.push_back(Plane{});
    setup.params.substeps = 200;
    setup.anchors.push_back(boxAnchor({1, 0.2, 1}, {0, -0.1, 0}));
    Projectile ball;
    ball.radius = 0.05;
    ball.position = {0.4, 0.5, 0.01};
    ball.velocity = {-speed, 0, 0};
    setup.projectiles.push_back(ball);
    return setup;
}
constexpr uint32_t kCells = kAcross * kAcross * kHigh;
uint32_t layerOf(uint32_t cell) {
    return cell / kAcross % kHigh;
}

TEST_F(Anchors, AColumnInTheGroundBreaksAtItsBaseWhichStays) {
    for (const Regimes regimes : {Regimes{false, false}, Regimes{true, true}}) {
        auto solver = makeSolver(with(columnInTheGround(6), regimes));
        const auto before = exportedFrame(*solver, kCells).particles;
        for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        const ExportedFrame after = exportedFrame(*solver, kCells);
        const uint32_t base = after.fragments[0];
        uint32_t highest = 0;
        for (uint32_t i = 0; i < kCells; ++i) {
            EXPECT_TRUE(layerOf(i) > 0 || sameBits(before[i], after.particles[i])) << "cell " << i;
            if (after.fragments[i] == base) highest = std::max(highest, layerOf(i));
        }
        EXPECT_GT(solver->stats().bonds_broken, 8u);
        EXPECT_LE(highest, kHigh / 3);  // what stands is a stump
        EXPECT_LT(after.particles[kCells - 1].position.y, 0.4);
    }
}

TEST_F(Anchors, ALightTouchBreaksNothingAndItSleeps) {
    auto solver = makeSolver(with(columnInTheGround(0.05), {true, true}));
    for (int frame = 0; frame < 120; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_EQ(solver->stats().fragments, 1u);
    EXPECT_EQ(solver->stats().awake_particles, 0u);
}

TEST_F(Anchors, TheBooksCloseWhileItBreaks) {
    auto solver = makeSolver(columnInTheGround(6));
    solver->measure();
    const double before = energySum(solver->stats().energy), put_in = solver->stats().energy.kinetic;
    for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_NEAR(energySum(solver->stats().energy), before, 0.01 * put_in);
    EXPECT_EQ(solver->stats().energy.external, 0);  // what stands does no work
}

/// A post of two small cells, the lower one held, and a heavy ball that comes at the upper one (m/s).
SceneSetup postOfTwoCells(double speed) {
    constexpr double kSmall = 0.004;  // m
    SceneSetup setup = freeBody(latticeBody(1, 2, 1, kSmall));
    setup.bodies[0].material.critical_velocity = 5;
    setup.params.substeps = 1500;
    setup.anchors.push_back(boxAnchor({kSmall, kSmall, kSmall}, {0, 0.5 * kSmall, 0}));
    Projectile ball;
    ball.radius = 5 * kSmall;
    ball.position = {0.1, 1.5 * kSmall, 0};
    ball.velocity = {-speed, 0, 0};
    ball.start_time = 0.4;  // by then the post sleeps as one
    setup.projectiles.push_back(ball);
    return setup;
}

/// However few cells it has, what is held cannot give way as one: the ball would go through the upper cell.
TEST_F(Anchors, ABallDoesNotGoThroughTheFreeCellOfAHeldCrumb) {
    auto solver = makeSolver(with(postOfTwoCells(33), {true, true}));
    for (int frame = 0; frame < 24; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_EQ(solver->stats().sleeping_fragments, 1u);
    ASSERT_EQ(solver->advanceSubsteps(20), StepStatus::kOk);
    solver->measure();
    const double before = energySum(solver->stats().energy), put_in = solver->stats().energy.kinetic;
    const double stood = exportedFrame(*solver, 2).particles[1].position.x;
    for (int frame = 0; frame < 6; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_GT(put_in, 100);  // J
    EXPECT_NEAR(energySum(solver->stats().energy), before, 0.005 * put_in);
    EXPECT_EQ(solver->stats().bonds_broken, 1u);
    EXPECT_LT(exportedFrame(*solver, 2).particles[1].position.x, stood - 0.1);
}

TEST_F(AnchorsOnTheCpu, TheNumberOfThreadsChangesNoBit) {
    uint64_t hash[2];
    for (const size_t threads : {1u, 2u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        auto solver = makeCpuSolver(with(columnInTheGround(6), {true, true}));
        for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        hash[threads - 1] = solver->stateHash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

TEST_F(AnchorsOnTheCpu, AnAnchorThatHoldsNothingIsRefused) {
    SceneSetup setup = cantilever();
    setup.anchors.push_back(boxAnchor({0.1, 0.1, 0.1}, {3, 3, 3}));
    try {
        makeCpuSolver(setup);
        FAIL() << "no complaint";
    } catch (const InputFileError& error) {
        EXPECT_NE(std::string(error.what()).find("Anchor 1 "), std::string::npos) << error.what();
    }
}

TEST_F(AnchorsOnTheCpu, OnlyWhatIsHeldMayStandInTheGround) {
    SceneSetup setup = columnInTheGround(6);
    EXPECT_NO_THROW(makeCpuSolver(setup));
    setup.anchors.clear();
    EXPECT_THROW(makeCpuSolver(setup), InputFileError);
}

}  // namespace
}  // namespace demolish::tests
