// SPDX-License-Identifier: Apache-2.0
// The floor's substep is a real one: it pushes back, keeps both momenta, loses energy only to its dampers,
// and breaks what is stretched too far.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/bench/floor_problem.h"

namespace demolish {
namespace {

using DoubleVector = Vec3<double>;

DoubleVector wide(const FloorVector& v) {
    return {v.x, v.y, v.z};
}

DoubleVector linearMomentum(const FloorProblem& problem) {
    DoubleVector sum;
    for (const auto& state : problem.states) sum = sum + wide(state.velocity);
    return sum;
}

DoubleVector angularMomentum(const FloorProblem& problem) {
    DoubleVector sum;
    for (const auto& state : problem.states)
        sum = sum + cross(wide(state.position), wide(state.velocity)) +
              (1.0 / problem.constants.inverse_inertia) * wide(state.spin);
    return sum;
}

double kineticEnergy(const FloorProblem& problem) {
    double sum = 0;
    for (const auto& state : problem.states)
        sum += 0.5 * length2(wide(state.velocity)) +
               0.5 / problem.constants.inverse_inertia * length2(wide(state.spin));
    return sum;
}

/// Two particles a spacing apart along x, bonded.
FloorProblem pair() {
    BreakableBody body;
    body.spacing = 0.01;
    body.particles.resize(2);
    body.particles[1].seed = {0.01, 0, 0};
    body.bonds.push_back({0, 1, 1e-4, {}, {1, 0, 0}, 0.01});
    FloorProblem problem = makeFloorProblem(body);
    for (auto& state : problem.states) state.velocity = state.spin = {};
    return problem;
}

TEST(FloorLaw, ABondIsStoredFromBothEnds) {
    const FloorProblem problem = pair();
    EXPECT_EQ(problem.row, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(problem.other, (std::vector<uint32_t>{1, 0}));
    EXPECT_FLOAT_EQ(problem.rest[0].x, 1);
    EXPECT_FLOAT_EQ(problem.rest[1].x, -1);
}

TEST(FloorLaw, AStretchedBondSwingsAtItsFrequency) {
    FloorProblem problem = pair();
    problem.constants.damping = 0;
    problem.states[1].position.x += 0.01f;
    // x'' = -2 k x / m: a period is 2 pi / sqrt(2).
    const double period = 2 * kPi / std::sqrt(2.0);
    stepOnHost(problem, static_cast<uint32_t>(std::lround(period / 2 / problem.constants.step)));
    EXPECT_NEAR(problem.states[1].position.x - problem.states[0].position.x, 0.99, 2e-4);
    stepOnHost(problem, static_cast<uint32_t>(std::lround(period / 2 / problem.constants.step)));
    EXPECT_NEAR(problem.states[1].position.x - problem.states[0].position.x, 1.01, 2e-4);
}

TEST(FloorLaw, ABondBreaksBeyondItsLimitAndPullsNoMore) {
    FloorProblem problem = pair();
    problem.states[1].position.x += 0.6f;
    stepOnHost(problem, 1);
    EXPECT_LT(problem.rest[0].w, 0);
    EXPECT_LT(problem.rest[1].w, 0);
    const FloorVector before = problem.states[1].velocity;
    stepOnHost(problem, 1);
    EXPECT_EQ(problem.states[1].velocity.x, before.x);
}

TEST(FloorLaw, ABlockKeepsItsMomentaAndComesToRest) {
    FloorProblem problem = makeFloorProblem(*stoneBlock(125));
    const DoubleVector linear = linearMomentum(problem), angular = angularMomentum(problem);
    const double kinetic = kineticEnergy(problem);
    stepOnHost(problem, 400);
    EXPECT_LT(length(linearMomentum(problem) - linear), 1e-5);
    EXPECT_LT(length(angularMomentum(problem) - angular), 1e-4);
    EXPECT_LT(kineticEnergy(problem), 0.5 * kinetic) << "dampers take energy out";
    for (const auto& bond : problem.rest) EXPECT_GT(bond.w, 0) << "stirring must not break it";
}

TEST(FloorLaw, TheStepIsStableWithoutDampers) {
    FloorProblem problem = makeFloorProblem(*stoneBlock(125));
    problem.constants.damping = 0;
    const double kinetic = kineticEnergy(problem);
    stepOnHost(problem, 2000);
    EXPECT_LT(kineticEnergy(problem), 1.5 * kinetic);
    EXPECT_GT(kineticEnergy(problem), 0.1 * kinetic) << "half of it is in the springs";
}

}  // namespace
}  // namespace demolish
