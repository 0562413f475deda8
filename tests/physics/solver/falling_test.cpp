// SPDX-License-Identifier: Apache-2.0
// What falls as a rigid body falls as it does with its bonds, although its steps are ten times as long.
#include <cmath>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Falling : public OnEitherDevice {};

/// A brick that is thrown up, at steps so long that half of one makes a difference.
SceneSetup thrownBrick(bool hand_over) {
    SceneSetup setup = freeBody(latticeBody(3, 4, 6, 0.05, 0.2));
    setup.bodies[0].material = brittleMaterial();
    setup.bodies[0].position = {0, 0.5, 0};
    setup.bodies[0].velocity = {0.5, 2, -0.3};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 40;
    setup.params.hand_over = hand_over;
    return setup;
}

/// A contact step is ten times as long as a substep, and yet a body has the energy of its fall at any moment.
TEST_F(Falling, AFallHasTheEnergyOfTheBonds) {
    auto rigid = makeSolver(thrownBrick(true));
    auto bonded = makeSolver(thrownBrick(false));
    for (int frame = 0; frame < 40; ++frame) {
        ASSERT_EQ(rigid->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(bonded->advanceFrame(), StepStatus::kOk);
    }
    ASSERT_EQ(rigid->stats().bonded_particles, 0u);
    rigid->measure();
    bonded->measure();
    const EnergyLedger &a = rigid->stats().energy, &b = bonded->stats().energy;
    EXPECT_NEAR(a.kinetic, b.kinetic, 1e-4 * b.kinetic);
    EXPECT_NEAR(a.potential, b.potential, 1e-4 * b.kinetic);
}

/// And none of it is lost when its bonds wake for the landing.
TEST_F(Falling, ABodyThatWakesLandsAsItFell) {
    SceneSetup setup = thrownBrick(true);
    setup.params.colliders.push_back(Plane{});
    setup.bodies[0].material.critical_velocity = 9;  // so that the landing wakes it and breaks nothing
    auto solver = makeSolver(setup);
    solver->measure();
    const double start = energySum(solver->stats().energy), fall = 9.81 * 0.5 * solver->stats().mass;
    bool was_rigid = false, woke = false;
    while (solver->stats().time < 0.75) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        was_rigid = was_rigid || solver->stats().bonded_particles == 0;
        woke = woke || (was_rigid && solver->stats().bonded_particles > 0);
    }
    solver->measure();
    EXPECT_TRUE(woke);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_LT(std::abs(energySum(solver->stats().energy) - start), 2e-3 * fall);
}

}  // namespace
}  // namespace demolish::tests
