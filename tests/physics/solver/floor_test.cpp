// SPDX-License-Identifier: Apache-2.0
// Bodies on planes: standing still, static and sliding friction (physics.md D 4, models.md E.4).
#include <cmath>
#include <vector>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Floor : public OnEitherDevice {};

TEST_F(Floor, ASettledBodyStandsStill) {
    SceneSetup setup = freeBody(latticeBody(4, 5, 4, 0.05, 0.2));
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 100;
    setup.params.settle_time = 0.8;
    setup.bodies[0].material.critical_velocity = 3;
    auto solver = makeSolver(setup);
    const auto before = exportedFrame(*solver, 80).particles;
    for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    const auto after = exportedFrame(*solver, 80).particles;
    for (size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(after[i].position.x, before[i].position.x, 1e-4);
        EXPECT_NEAR(after[i].position.y, before[i].position.y, 1e-4);
        EXPECT_NEAR(after[i].position.z, before[i].position.z, 1e-4);
    }
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    solver->measure();
    EXPECT_LT(solver->stats().energy.kinetic, 1e-5 * solver->stats().mass);
}

/// A flat brick on a slope in the x-y plane; x points downhill along it.
SceneSetup onSlope(double tangent, double friction) {
    const double angle = std::atan(tangent);
    SceneSetup setup = freeBody(latticeBody(6, 2, 6, 0.05));
    setup.bodies[0].material.friction = friction;
    setup.bodies[0].material.critical_velocity = 100;
    setup.params.colliders.push_back(Plane{});
    setup.params.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
    setup.params.substeps = 100;
    setup.params.frame_time = 0.25;
    return setup;
}

double downhillSpeed(Solver& solver) {
    solver.measure();
    return solver.stats().linear_momentum.x / solver.stats().mass;
}

TEST_F(Floor, FrictionHoldsJustBelowItsAngle) {  // D 4
    for (const double share : {0.9, 0.99}) {
        auto held = makeSolver(onSlope(share * 0.5, 0.5));
        for (int k = 0; k < 2; ++k) ASSERT_EQ(held->advanceFrame(), StepStatus::kOk);
        EXPECT_LT(std::abs(downhillSpeed(*held)), 2e-3) << share;
    }
}

TEST_F(Floor, JustAboveItSlidesWithWhatFrictionLeaves) {  // D 4
    for (const double share : {1.01, 1.4}) {
        const double angle = std::atan(share * 0.5);
        auto sliding = makeSolver(onSlope(share * 0.5, 0.5));
        ASSERT_EQ(sliding->advanceFrame(), StepStatus::kOk);
        const double first = downhillSpeed(*sliding), start = sliding->stats().time;
        ASSERT_EQ(sliding->advanceFrame(), StepStatus::kOk);
        const double gain = (downhillSpeed(*sliding) - first) / (sliding->stats().time - start);
        const double expected = 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
        EXPECT_NEAR(gain, expected, 0.01 * expected) << share;
    }
}

}  // namespace
}  // namespace demolish::tests
