// SPDX-License-Identifier: Apache-2.0
// Meshes as what bodies fall on: as the sphere and the box that they are of, and a bowl, which no convex
// shape is.
#include <tbb/global_control.h>

#include <cmath>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/data/colliders.h"
#include "tests/physics/solver/collider_meshes.h"
#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/impact_on_collider.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class MeshColliders : public OnEitherDevice {};

constexpr double kRadius = 0.1, kGravity = 9.81;  // m, of the ball; m/s^2
const Sphere kBall{0.5, {0, -0.5, 0}};

const MeshShape& ballOfTriangles() {
    static const MeshShape shape = meshShape(test::makeSphere(0.5, 5), kBall.position);
    return shape;
}
const MeshShape& bowl() {
    static const MeshShape shape = meshShape(makeBowl(0.5, 0.45), {});
    return shape;
}

SceneSetup ballAt(const Double3& position, const Collider& collider) {
    SceneSetup setup = freeBody(ballBody(kRadius));
    setup.bodies[0].position = position;
    setup.bodies[0].material.rolling_friction = 0;
    setup.params.colliders = {collider};
    setup.params.gravity = {0, -kGravity, 0};
    setup.params.substeps = 100;
    setup.params.step_safety = 0.1;
    return setup;
}
SceneSetup cubeOver(const Collider& collider, double height) {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.05));
    setup.bodies[0].position = {0, height, 0};
    setup.params.gravity = {0, -kGravity, 0};
    setup.params.colliders = {collider};
    setup.params.substeps = 100;
    return setup;
}

double speedUp(Solver& solver) {
    solver.measure();
    return solver.stats().linear_momentum.y / solver.stats().mass;
}
double givenBack(const Collider& collider) {
    SceneSetup setup = ballAt({0, 0.001, 0}, collider);
    setup.bodies[0].material.restitution = 0.6;
    setup.bodies[0].velocity = {0, -2, 0};
    setup.params.gravity = {};
    auto solver = makeSolver(setup);
    for (int frame = 0; frame < 6; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
    return speedUp(*solver) / 2;
}

TEST_F(MeshColliders, ABallBouncesAsOnTheSphere) {
    EXPECT_NEAR(givenBack(ballOfTriangles()), givenBack(kBall), 5e-3);
}

TEST_F(MeshColliders, OffTheTopABallSlidesAsFastAsItsFallSays) {
    const double away = kBall.radius + kRadius, first = 0.15;
    Collider smooth = ballOfTriangles();
    smooth.friction = 0;
    SceneSetup setup = ballAt({away * std::sin(first), away * std::cos(first) - away, 0}, smooth);
    setup.params.ledger = false;
    auto solver = makeSolver(setup);
    double angle = first;
    while (angle < 0.6) {
        ASSERT_EQ(solver->advanceSubsteps(10), StepStatus::kOk);
        const auto at = exportedFrame(*solver, 1).particles[0].position;
        angle = std::atan2(double(at.x), double(at.y) - kBall.position.y);
    }
    solver->measure();
    const Double3 p = solver->stats().linear_momentum;
    const double speed = std::hypot(p.x, p.y) / solver->stats().mass;
    EXPECT_NEAR(speed / std::sqrt(2 * kGravity * away * (std::cos(first) - std::cos(angle))), 1, 0.03);
}

TEST_F(MeshColliders, ABrickSlidesOnTheBoxOfTriangles) {
    const double angle = std::atan(0.6), half = angle / 2;
    for (const double friction : {0.5, 0.7}) {
        SceneSetup setup = freeBody(latticeBody(6, 2, 6, 0.05));
        setup.bodies[0].material.friction = friction;
        setup.bodies[0].material.critical_velocity = 100;
        setup.bodies[0].rotation = {0, 0, std::sin(-half), std::cos(half)};
        const Quaternion turned{0, 0, std::sin(-half), std::cos(half)};
        setup.params.colliders = {
            meshShape(test::makeCube(4), {-2 * std::sin(angle), -2 * std::cos(angle), 0}, turned)};
        setup.params.gravity = {0, -kGravity, 0};
        setup.params.substeps = 100;
        auto solver = makeSolver(setup);
        for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const Double3 p = solver->stats().linear_momentum;
        const double slides = kGravity * (std::sin(angle) - friction * std::cos(angle)) * 0.5;
        EXPECT_NEAR(std::hypot(p.x, p.y) / solver->stats().mass, std::max(slides, 0.0),
                    0.02 * std::max(slides, 0.25))
            << friction;
    }
}

TEST_F(MeshColliders, ABallRollsDownTheBoxOfTrianglesWithFiveSeventhsOfTheSlope) {
    const double angle = std::atan(0.3), half = angle / 2;
    SceneSetup setup = ballAt({kRadius * std::sin(angle), kRadius * std::cos(angle) - kRadius, 0},
                              meshShape(test::makeCube(4), {-2 * std::sin(angle), -2 * std::cos(angle), 0},
                                        {0, 0, std::sin(-half), std::cos(half)}));
    setup.bodies[0].material.friction = 0.5;
    auto solver = makeSolver(setup);
    double speed[2], time[2];
    for (const int look : {0, 1}) {
        for (int frame = 0; frame < (look == 0 ? 6 : 20); ++frame)
            ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        solver->measure();
        const Double3 p = solver->stats().linear_momentum;
        speed[look] = std::hypot(p.x, p.y) / solver->stats().mass;
        time[look] = solver->stats().time;
    }
    const double expected = 5.0 / 7 * kGravity * std::sin(angle);
    EXPECT_NEAR((speed[1] - speed[0]) / (time[1] - time[0]), expected, 0.01 * expected);
}

/// Nothing of what is left lies in the wall or below it.
void expectInTheBowl(Solver& solver, size_t count) {
    const auto set = makeColliderSet<double>({bowl()});
    for (const ParticleInstance& particle : exportedFrame(solver, count).particles) {
        const Vec3<double> at{particle.position.x, particle.position.y, particle.position.z};
        EXPECT_GT(set.tangent(0, at).distance, -0.005);
        EXPECT_LT(length(at), 0.45);
    }
}

TEST_F(MeshColliders, WhatFallsIntoABowlComesToRestInIt) {
    for (const bool hand_over : {false, true}) {
        SceneSetup setup = with(cubeOver(bowl(), -0.2), {hand_over, hand_over});
        setup.bodies[0].position.x = 0.08;
        setup.bodies[0].material.critical_velocity = 20;
        auto solver = makeSolver(setup);
        for (int frame = 0; frame < 120; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        EXPECT_EQ(solver->stats().bonds_broken, 0u);
        expectInTheBowl(*solver, 64);
        solver->measure();
        EXPECT_LT(solver->stats().energy.kinetic, 2e-4 * solver->stats().mass) << hand_over;
    }
}

/// Pieces on both kinds of steps, at 5 m/s: none goes through the wall.
SceneSetup breakingInTheBowl() {
    SceneSetup setup = with(cubeOver(bowl(), -0.1), {true, true});
    setup.bodies[0].body = latticeBody(4, 4, 4, 0.05, 0.2);
    setup.bodies[0].material = brittleMaterial();
    setup.bodies[0].rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
    setup.bodies[0].velocity = {0, -5, 0};
    return setup;
}

TEST_F(MeshColliders, ABodyThatBreaksInABowlStaysInIt) {
    auto solver = makeSolver(breakingInTheBowl());
    for (int frame = 0; frame < 90; ++frame) ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
    EXPECT_GT(solver->stats().fragments, 3u);
    const auto set = makeColliderSet<double>({bowl()});
    for (const ParticleInstance& particle : exportedFrame(*solver, 64).particles) {
        const Vec3<double> at{particle.position.x, particle.position.y, particle.position.z};
        EXPECT_GT(set.tangent(0, at).distance, -0.01);
        EXPECT_TRUE(length(at) < 0.45 || at.y > -0.1) << "not through the wall";
    }
}

TEST_F(MeshColliders, TheStateDoesNotDependOnThreads) {
    const auto hashWith = [](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        auto solver = makeSolver(breakingInTheBowl());
        for (int frame = 0; frame < 20; ++frame) EXPECT_EQ(solver->advanceFrame(), StepStatus::kOk);
        return solver->stateHash();
    };
    EXPECT_EQ(hashWith(1), hashWith(2));
}

TEST_F(MeshColliders, ABodyThatFallsOntoAMeshWakes) {
    SceneSetup setup = with(cubeOver(ballOfTriangles(), 0.5), {true, true});
    setup.bodies[0].material.critical_velocity =
        9;  // so that the landing wakes it and breaks next to nothing
    auto solver = makeSolver(setup);
    bool was_rigid = false, woke = false;
    double fastest_up = 0;  // m/s
    while (solver->stats().time < 0.45) {
        ASSERT_EQ(solver->advanceFrame(), StepStatus::kOk);
        was_rigid = was_rigid || solver->stats().bonded_particles == 0;
        woke = woke || (was_rigid && solver->stats().bonded_particles > 0);
        fastest_up = std::max(fastest_up, speedUp(*solver));
    }
    EXPECT_TRUE(woke);
    EXPECT_LT(solver->stats().bonds_broken, 0.1 * solver->stats().bonds);
    EXPECT_GT(fastest_up, 0) << "it bounces";
}

TEST_F(MeshColliders, TheBooksCloseThroughAnImpactOnAMesh) {
    for (const bool hand_over : {false, true})
        EXPECT_LT(bookErrorOfImpactOn(ballOfTriangles(), hand_over), 0.05) << hand_over;
}

TEST_F(MeshColliders, ABodyThatStartsInAMeshIsRefusedByName) {
    SceneSetup setup = cubeOver(ballOfTriangles(), -0.5);
    try {
        makeSolver(setup);
        FAIL() << "it starts inside";
    } catch (const InputFileError& error) {
        EXPECT_NE(std::string(error.what()).find("Body 0 of the scene starts inside its collider 0, a mesh"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace demolish::tests
