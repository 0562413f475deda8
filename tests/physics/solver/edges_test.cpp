// SPDX-License-Identifier: Apache-2.0
// What meets the edges and corners of a collider, fast and from any side: no energy comes from nowhere,
// neither with bonds at work nor in contact steps.
#include <cmath>
#include <functional>
#include <random>

#include "tests/physics/solver/collider_meshes.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class OnEdges : public OnEitherDevice {};

constexpr double kArrives = 0.05;  // s

/// How something comes to a collider that is turned in any way.
struct Throw {
    Double3 from;  // m, at 0 s
    Double3 velocity;
    Quaternion turned;  // the collider's
};
class RandomThrows {
  public:
    Throw next(double speed) {
        const double turn[4] = {normal_(random_), normal_(random_), normal_(random_), normal_(random_)};
        const double q = std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3]));
        Double3 way{normal_(random_), normal_(random_), normal_(random_)};
        const double faster = speed / std::hypot(way.x, way.y, way.z);
        way = {faster * way.x, faster * way.y, faster * way.z};
        const Double3 aim{aside_(random_), aside_(random_), aside_(random_)};
        return {{aim.x - kArrives * way.x, aim.y - kArrives * way.y, aim.z - kArrives * way.z},
                way,
                {turn[0] / q, turn[1] / q, turn[2] / q, turn[3] / q}};
    }

  private:
    std::mt19937 random_{5};
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> aside_{-0.25, 0.25};  // m
};

using Setup = std::function<SceneSetup(const Throw&)>;

Collider boxOf(const Throw& thrown) {
    Collider box = Box{{0.4, 0.3, 0.2}, {}, thrown.turned};
    box.restitution = 0.5;
    return box;
}
/// Four cells of 3 cm, as a substep of 10 us has them.
SceneSetup crumb(const Throw& thrown, const Collider& collider, bool hand_over) {
    SceneSetup setup = with(freeBody(latticeBody(1, 2, 2, 0.03)), {hand_over, hand_over});
    setup.params.substeps = 1666;
    setup.params.colliders = {collider};
    setup.bodies[0].material.critical_velocity = 1000;
    setup.bodies[0].position = thrown.from;
    setup.bodies[0].velocity = thrown.velocity;
    return setup;
}
/// A ball of 5 cm, while the only body sleeps far away.
SceneSetup ball(const Throw& thrown) {
    SceneSetup setup = crumb({{0, 50, 0}, {}, thrown.turned}, boxOf(thrown), true);
    Projectile ball;
    ball.position = thrown.from;
    ball.velocity = thrown.velocity;
    setup.projectiles = {ball};
    return setup;
}

/// Of twenty throws each closes to `share` of what was brought, and some hit.
void expectClosedBooks(double speed, double share, const Setup& setup) {
    RandomThrows throws;
    int hits = 0;
    for (int k = 0; k < 20; ++k) {
        SCOPED_TRACE(k);
        auto solver = makeSolver(setup(throws.next(speed)));
        solver->measure();
        const double before = energySum(solver->stats().energy), brought = solver->stats().energy.kinetic;
        for (int frame = 0; frame < 6; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const EnergyLedger& energy = solver->stats().energy;
        hits += energy.damping + energy.friction > 0.02 * brought;
        EXPECT_NEAR(energySum(energy), before, share * brought);
    }
    EXPECT_GE(hits, 5) << speed;
}

TEST_F(OnEdges, OfABoxBooksOfBondedCellsClose) {
    for (const double speed : {20.0, 40.0, 80.0, 200.0})
        expectClosedBooks(speed, 5e-3,
                          [](const Throw& thrown) { return crumb(thrown, boxOf(thrown), false); });
}
TEST_F(OnEdges, OfAMeshBooksOfBondedCellsClose) {
    const auto mesh = makeColliderMesh(test::makeCube(0.3), "test.obj", {});
    for (const double speed : {20.0, 80.0})
        expectClosedBooks(speed, 5e-3, [&](const Throw& thrown) {
            Collider collider = MeshShape{mesh, 1, {}, thrown.turned};
            collider.restitution = 0.5;
            return crumb(thrown, collider, false);
        });
}
/// What comes far in a contact step is met in substeps.
TEST_F(OnEdges, OfABoxBooksOfWhatWasRigidClose) {
    for (const double speed : {80.0, 160.0, 200.0})
        expectClosedBooks(speed, 5e-3,
                          [](const Throw& thrown) { return crumb(thrown, boxOf(thrown), true); });
}
TEST_F(OnEdges, OfABoxBooksOfFastBallsClose) {
    for (const double speed : {80.0, 200.0}) expectClosedBooks(speed, 5e-3, ball);
}

}  // namespace
}  // namespace demolish::tests
