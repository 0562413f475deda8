// SPDX-License-Identifier: Apache-2.0
// A body thrown onto a collider that stands on the floor, until it lies in pieces.
#pragma once
#include <cmath>

#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {

/// Twelve frames; fails the test when a step does, or when little breaks. Gives how far the energy strays,
/// over that of the impact.
inline double bookErrorOfImpactOn(const Collider& collider, bool hand_over) {
    SceneSetup setup = with(freeBody(latticeBody(6, 6, 6, 0.05, 0.2)), {hand_over, hand_over});
    setup.bodies[0].rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    setup.bodies[0].position = {0.1, 0.2, 0.05};
    setup.bodies[0].velocity = {0, -3, 0};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders = {Plane{{0, 1, 0}, -1}, collider};
    setup.params.substeps = 200;
    auto solver = makeSolver(setup);
    solver->measure();
    const double before = energySum(solver->stats().energy), impact = solver->stats().energy.kinetic;
    for (int frame = 0; frame < 12; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_GT(solver->stats().bonds_broken, 0.05 * solver->stats().bonds);
    return std::abs(energySum(solver->stats().energy) - before) / impact;
}

}  // namespace demolish::tests
