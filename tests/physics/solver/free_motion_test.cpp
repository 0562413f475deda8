// SPDX-License-Identifier: Apache-2.0
// Free bodies: rigid invariance, spinning, flight, damping (physics.md D 15, 16, 18).
#include <cmath>

#include "sim_cuda/solver/double_solver.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class FreeMotion : public OnEitherDevice {};
class FreeMotionDouble : public OnTheCpu {};

double norm(const Double3& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}
double distance(const Double3& a, const Double3& b) {
    return norm({a.x - b.x, a.y - b.y, a.z - b.z});
}
double mechanical(const FrameStats& stats) {
    return stats.energy.kinetic + stats.energy.elastic + stats.energy.potential;
}

/// Turned, far from the origin, at rest.
SceneSetup movedBody() {
    SceneSetup setup = freeBody(latticeBody(3, 4, 3, 0.1, 0.2));
    setup.bodies[0].rotation = {0.5, -0.5, 0.1, 0.7};
    setup.bodies[0].position = {40, -30, 20};
    return setup;
}

/// Largest speed of a particle over that which a force k_N L0 gives in one substep.
double strayForce(Solver& solver) {
    EXPECT_EQ(solver.advanceSubsteps(1), StepStatus::kOk);
    solver.measure();
    const double h = 0.1, mass = 2400 * h * h * h, k = solver.softening().bond_modulus * h;
    const double speed = std::sqrt(2 * solver.stats().energy.kinetic / mass);
    return speed * mass / (k * h * solver.stats().time_step);
}

TEST_F(FreeMotionDouble, ATurnedAndMovedBodyFeelsNoForce) {
    EXPECT_LT(strayForce(*makeCpuSolverDouble(movedBody())), 1e-11);
}

TEST_F(FreeMotion, ATurnedAndMovedBodyFeelsNoForce) {
    EXPECT_LT(strayForce(*makeSolver(movedBody())), 1e-5);
}

constexpr double kSpin = 13;  // rad/s

struct Drift {
    double angular = 0, energy = 0, revolutions = 0;
};
Drift spinFor(Solver& solver, uint32_t substeps) {
    solver.measure();
    const Double3 before = solver.stats().angular_momentum;
    const double energy = mechanical(solver.stats());
    EXPECT_EQ(solver.advanceSubsteps(substeps), StepStatus::kOk);
    solver.measure();
    EXPECT_EQ(solver.stats().bonds_broken, 0u);
    return {distance(solver.stats().angular_momentum, before) / norm(before),
            std::abs(mechanical(solver.stats()) / energy - 1),
            kSpin * solver.stats().time / 6.283185307179586};
}

TEST_F(FreeMotionDouble, ASpinningBodyKeepsItsAngularMomentumAndEnergy) {
    const Drift drift = spinFor(*makeCpuSolverDouble(spinningBody(kSpin)), 90'000);
    EXPECT_GT(drift.revolutions, 10);
    EXPECT_LT(drift.angular, 1e-11);
    EXPECT_LT(drift.energy, 1e-5);
}

TEST_F(FreeMotion, ASpinningBodyInSinglePrecision) {
    const Drift drift = spinFor(*makeSolver(spinningBody(kSpin)), 90'000);
    EXPECT_LT(drift.angular, 1e-4);
    EXPECT_LT(drift.energy, 1e-4);
}

TEST_F(FreeMotion, NothingBrakesFlight) {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.05, 0.2));
    setup.bodies[0].velocity = {3, -2, 5};
    setup.params.gravity = {0, -9.81, 0};
    auto solver = makeSolver(setup);
    solver->measure();
    const Double3 before = solver->stats().linear_momentum;
    for (int frame = 0; frame < 6; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    const FrameStats& stats = solver->stats();
    EXPECT_NEAR(stats.linear_momentum.x / before.x, 1, 1e-5);
    EXPECT_NEAR(stats.linear_momentum.z / before.z, 1, 1e-5);
    EXPECT_NEAR(stats.linear_momentum.y - before.y, -9.81 * stats.time * stats.mass,
                1e-4 * std::abs(before.y));
    EXPECT_LT(std::abs(stats.energy.damping), 1e-6 * stats.energy.kinetic);
    EXPECT_NEAR(stats.time, 0.1, 1e-9);
}

TEST_F(FreeMotionDouble, DampingKeepsMomenta) {
    SceneSetup setup = spinningBody(kSpin);
    setup.bodies[0].material.damping_ratio = 0.5;
    setup.bodies[0].velocity = {1, 2, 3};
    setup.params.step_safety = 0.4;
    auto solver = makeCpuSolverDouble(setup);
    solver->measure();
    const Double3 linear = solver->stats().linear_momentum, angular = solver->stats().angular_momentum;
    ASSERT_EQ(solver->advanceSubsteps(4000), StepStatus::kOk);
    solver->measure();
    EXPECT_LT(distance(solver->stats().linear_momentum, linear), 1e-12 * norm(linear));
    EXPECT_LT(distance(solver->stats().angular_momentum, angular), 1e-11 * norm(angular));
    EXPECT_GT(solver->stats().energy.damping, 0);  // the stretch it started without
    const double settled = solver->stats().energy.damping;
    ASSERT_EQ(solver->advanceSubsteps(4000), StepStatus::kOk);
    EXPECT_LT(solver->stats().energy.damping - settled, 0.02 * settled);  // a rigid spin is not damped
}

}  // namespace
}  // namespace demolish::tests
