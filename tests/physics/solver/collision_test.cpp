// SPDX-License-Identifier: Apache-2.0
// Two bricks smash into each other: momenta of everything, through breaking, contact and friction (physics.md
// D 17).
#include <cmath>

#include "sim_cuda/solver/double_solver.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class Collision : public OnEitherDevice {};
class CollisionDouble : public OnTheCpu {};

SceneSetup collision() {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.05, 0.2));
    setup.bodies[0].material.tough_cells = 0;
    setup.bodies[0].material.critical_velocity = 0.05;
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[0].position = {-0.13, 0, 0};
    setup.bodies[0].velocity = {8, 1, 0};
    setup.bodies[1].position = {0.13, 0.04, 0.03};
    setup.bodies[1].velocity = {-8, 0, 1};
    setup.bodies[1].angular_velocity = {0, 5, 0};
    return setup;
}

struct Change {
    double linear = 0, angular = 0, broken = 0;
};

/// Over sum m |v| and sum m |v| times the size of the scene.
Change changeOver(Solver& solver, uint32_t substeps) {
    solver.measure();
    const Double3 p = solver.stats().linear_momentum, l = solver.stats().angular_momentum;
    EXPECT_EQ(solver.advanceSubsteps(substeps), StepStatus::kOk);
    solver.measure();
    const Double3 p1 = solver.stats().linear_momentum, l1 = solver.stats().angular_momentum;
    const double scale = solver.stats().mass * 8;
    const auto off = [](const Double3& a, const Double3& b) {
        return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    };
    return {off(p, p1) / scale, off(l, l1) / (0.2 * scale),
            static_cast<double>(solver.stats().bonds_broken) / solver.stats().bonds};
}

TEST_F(CollisionDouble, MomentaAreKeptThroughFractureInDouble) {
    const Change change = changeOver(*makeCpuSolverDouble(collision()), 4000);
    EXPECT_GT(change.broken, 0.99);
    EXPECT_LT(change.linear, 1e-13);
    EXPECT_LT(change.angular, 1e-12);
}

TEST_F(Collision, MomentaAreKeptThroughFractureInSingle) {
    const Change change = changeOver(*makeSolver(collision()), 4000);
    EXPECT_GT(change.broken, 0.99);
    EXPECT_LT(change.linear, 1e-6);
    EXPECT_LT(change.angular, 2e-5);
}

TEST_F(CollisionDouble, HertzContactsKeepMomentaToo) {
    SceneSetup setup = collision();
    setup.params.contact_law = ContactLaw::kHertz;
    setup.bodies[0].material.adhesion_energy = 0.1;
    const Change change = changeOver(*makeCpuSolverDouble(setup), 4000);
    EXPECT_LT(change.linear, 1e-13);
    EXPECT_LT(change.angular, 1e-12);
}

}  // namespace
}  // namespace demolish::tests
