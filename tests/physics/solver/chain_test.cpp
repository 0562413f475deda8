// SPDX-License-Identifier: Apache-2.0
// A chain of cubes that spins, end over end: each bond is stretched by what the cubes beyond it pull
// (physics.md D 12, on the device under test).
#include <cmath>

#include "sim_cuda/physics/bond_stiffness.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

constexpr uint32_t kCubes = 12;
constexpr double kEdge = 0.1;  // m

class SpinningChain : public OnEitherDevice {
  protected:
    /// Damped, so that only the stretch is left of what the sudden spin sets swinging.
    static SceneSetup chain(double spin) {
        SceneSetup setup = freeBody(latticeBody(kCubes, 1, 1, kEdge));
        setup.bodies[0].angular_velocity = {0, spin, 0};
        setup.bodies[0].material.damping_ratio = 0.15;
        setup.bodies[0].material.critical_velocity = 1000;
        setup.params.hand_over = setup.params.sleeping = false;
        return setup;
    }
};

TEST_F(SpinningChain, IsStretchedBySumsOverTheCubesBeyondEachBond) {
    const auto solver = makeSolver(chain(80));
    for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    solver->measure();
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    // The same chain at rest, solved by hand: k (l_b - l) = m w^2 sum of the radii beyond bond b.
    const double mass = Material{}.density * kEdge * kEdge * kEdge,
                 k = solver->softening().bond_modulus * kEdge;
    double length[kCubes - 1], spin = 0;
    for (double& l : length) l = kEdge;
    const double momentum = solver->stats().angular_momentum.y;
    for (int round = 0; round < 200; ++round) {
        double radius[kCubes], centre = 0;
        radius[0] = 0;
        for (uint32_t i = 1; i < kCubes; ++i) radius[i] = radius[i - 1] + length[i - 1];
        for (const double r : radius) centre += r / kCubes;
        double inertia = kCubes * mass * kEdge * kEdge * 0.4 * std::pow(3 / (4 * 3.14159265358979), 2.0 / 3);
        for (double& r : radius) {
            r -= centre;
            inertia += mass * r * r;
        }
        spin = momentum / inertia;
        double pull = 0;
        for (uint32_t b = kCubes - 1; b > 0; --b) {
            pull += mass * spin * spin * radius[b];
            length[b - 1] = kEdge + pull / k;
        }
    }
    double elastic = 0, longest = 0;
    for (const double l : length) {
        elastic += 0.5 * k * (l - kEdge) * (l - kEdge);
        longest = std::max(longest, l / kEdge - 1);
    }
    EXPECT_GT(longest, 1e-3) << "enough to measure";
    // The damper sees velocities half a step late, and thereby a little of the rotation: 0.5 % here, in
    // proportion to the damping.
    EXPECT_NEAR(solver->stats().energy.elastic / elastic, 1, 0.008);
}

}  // namespace
}  // namespace demolish::tests
