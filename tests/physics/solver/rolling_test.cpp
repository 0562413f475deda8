// SPDX-License-Identifier: Apache-2.0
// A ball on a floor and on a slope: from sliding to rolling, and rolling down (physics.md D 4, 5).
#include <cmath>
#include <vector>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Rolling : public OnEitherDevice {};

constexpr double kRadius = 0.1, kGravity = 9.81;

/// A ball that rests on the floor with the weight's own overlap; x points downhill.
SceneSetup ballOnSlope(double tangent, double friction) {
    const double angle = std::atan(tangent);
    SceneSetup setup = freeBody(ballBody(kRadius));
    Material& material = setup.bodies[0].material;
    material.friction = friction;
    material.rolling_friction = 0;
    material.restitution = 0.1;
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {kGravity * std::sin(angle), -kGravity * std::cos(angle), 0};
    setup.params.substeps = 100;
    setup.params.step_safety = 0.1;
    setup.params.settle_time = tangent > 0 ? 0 : 0.3;
    return setup;
}

double speed(Solver& solver) {
    solver.measure();
    return solver.stats().linear_momentum.x / solver.stats().mass;
}
/// m/s^2, mean over `seconds` after a first tenth of a second.
double acceleration(Solver& solver, double seconds) {
    const auto substeps = [&](double time) {
        return static_cast<uint32_t>(std::lround(time / solver.stats().time_step));
    };
    EXPECT_EQ(solver.advanceSubsteps(substeps(0.1)), StepStatus::kOk);
    const double first = speed(solver), start = solver.stats().time;
    EXPECT_EQ(solver.advanceSubsteps(substeps(seconds)), StepStatus::kOk);
    return (speed(solver) - first) / (solver.stats().time - start);
}

TEST_F(Rolling, ABallRollsDownWithFiveSeventhsOfTheSlope) {  // D 4
    for (const double tangent : {0.3, 0.95 * 3.5 * 0.3}) {
        auto solver = makeSolver(ballOnSlope(tangent, 0.3));
        const double expected = 5.0 / 7 * kGravity * std::sin(std::atan(tangent));
        EXPECT_NEAR(acceleration(*solver, 0.3) / expected, 1, 0.01) << tangent;
    }
}

TEST_F(Rolling, BeyondThreeAndAHalfTimesFrictionItSlides) {  // D 4
    const double tangent = 1.2 * 3.5 * 0.3, angle = std::atan(tangent);
    auto solver = makeSolver(ballOnSlope(tangent, 0.3));
    const double expected = kGravity * (std::sin(angle) - 0.3 * std::cos(angle));
    EXPECT_NEAR(acceleration(*solver, 0.3) / expected, 1, 0.01);
}

TEST_F(Rolling, ASlidingBallRollsAtFiveSeventhsOfItsSpeed) {  // D 5
    const double v = 3, friction = 0.4, expected_time = 2 * v / (7 * friction * kGravity);
    SceneSetup setup = ballOnSlope(0, friction);
    setup.bodies[0].velocity = {v, 0, 0};
    auto solver = makeSolver(setup);
    const double step = solver->stats().time_step;
    std::vector<double> speeds{speed(*solver)};
    constexpr uint32_t kLook = 20;
    while (solver->stats().time < 1.5 * expected_time) {
        ASSERT_EQ(solver->advanceSubsteps(kLook), StepStatus::kOk);
        speeds.push_back(speed(*solver));
    }
    EXPECT_NEAR(speeds.back() / (5.0 / 7 * v), 1, 0.01);
    // Sliding ends where the straight line of braking meets the final speed.
    const auto middle = static_cast<size_t>(0.5 * expected_time / (kLook * step));
    const double braking = (speeds[0] - speeds[middle]) / (static_cast<double>(middle) * kLook * step);
    EXPECT_NEAR(braking / (friction * kGravity), 1, 0.01);
    size_t rolling = 0;
    while (rolling < speeds.size() && speeds[rolling] > 1.002 * speeds.back()) ++rolling;
    EXPECT_NEAR(static_cast<double>(rolling) * kLook * step / expected_time, 1, 0.01);
}

/// In steps of a microsecond friction takes less of the speed than its last digit counts.
TEST_F(Rolling, AFastBallFeelsItsFrictionInTinySteps) {
    SceneSetup setup = ballOnSlope(0, 0.4);
    setup.params.settle_time = 0;
    setup.params.substeps = 16000;
    Projectile ball;
    ball.radius = kRadius;
    ball.position = {0, kRadius, 1};
    ball.velocity = {100, 0, 0};
    setup.projectiles = {ball};
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy);
    ASSERT_EQ(solver->advanceSubsteps(100000), StepStatus::kOk);
    solver->measure();
    const EnergyLedger& energy = solver->stats().energy;
    EXPECT_GT(energy.friction, 1e-3 * before);
    EXPECT_NEAR(energySum(energy), before, 0.02 * energy.friction);
}

}  // namespace
}  // namespace demolish::tests
