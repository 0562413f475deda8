// SPDX-License-Identifier: Apache-2.0
// A piece of many cells that rolls comes to rest: what resists goes by what turns, not by one cell (models.md
// E.5).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/physics/models/packed_body.h"
#include "tests/physics/models/shots.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class RollingBody : public OnEitherDevice {};

constexpr double kDiameter = 0.36, kStart = 0.3;  // m, m/s

/// A ball of cells that rolls along x.
SceneSetup rollingBall() {
    Material material = sheetMaterial(8, 50);
    material.rolling_friction = 0.3;
    SceneSetup setup = standing(sphereBody(kDiameter, 300, 1), material, 150);
    setup.params.gravity = {0, -9.81, 0};
    setup.params.ledger = false;
    setup.params.hand_over = true;
    setup.bodies[0].velocity = {kStart, 0, 0};
    setup.bodies[0].angular_velocity = {0, 0, -kStart / (kDiameter / 2)};
    return setup;
}

double speedOf(Solver& solver) {
    solver.measure();
    return std::sqrt(2 * solver.stats().energy.kinetic / solver.stats().mass);
}

TEST_F(RollingBody, ComesToRestAsOneRigidPiece) {
    auto solver = makeSolver(rollingBall());
    double after_a_second = 0;
    for (int frame = 0; frame < 150; ++frame) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        if (frame == 59) after_a_second = speedOf(*solver);
    }
    const double at_last = speedOf(*solver);
    std::printf("%.3f m/s after 1 s, %.4f after 2.5 s; %u rigid, %u bonds broken\n", after_a_second, at_last,
                solver->stats().rigid_fragments, solver->stats().bonds_broken);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_LT(after_a_second, 0.5 * kStart);
    EXPECT_LT(at_last, 0.02);
}

}  // namespace
}  // namespace demolish::tests
