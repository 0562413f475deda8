// SPDX-License-Identifier: Apache-2.0
// A box as what bodies fall on: they rest, slide, sleep and break on it as on a plane, and fall past it
// beside it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/physics/solver/exported_frame.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/regimes_of.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

class OnABox : public OnEitherDevice {};

/// Stands on the floor y = 0; its top is 0.2 m above it.
const Box kStep{{0.4, 0.2, 0.4}, {0, 0.1, 0}, {}};

/// A cube of 0.2 m above the floor and the step.
SceneSetup cubeAt(const Double3& position) {
    SceneSetup setup = freeBody(latticeBody(4, 4, 4, 0.05));
    setup.bodies[0].material.critical_velocity = 20;
    setup.bodies[0].position = position;
    setup.params.gravity = {0, -9.81, 0};
    setup.params.colliders = {Plane{}, kStep};
    setup.params.substeps = 100;
    return setup;
}

void advance(Solver& solver, int frames) {
    for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
}

struct Extent {
    double lowest = 1e30, highest = -1e30;  ///< m, of the particles' centres
};
Extent extentOf(Solver& solver, size_t count) {
    Extent extent;
    for (const ParticleInstance& particle : exportedFrame(solver, count).particles) {
        extent.lowest = std::min<double>(extent.lowest, particle.position.y);
        extent.highest = std::max<double>(extent.highest, particle.position.y);
    }
    return extent;
}

TEST_F(OnABox, WhatFallsOntoItRestsAndWhatFallsBesideItFallsPast) {
    for (const bool hand_over : {false, true})
        for (const bool beside : {false, true}) {
            SCOPED_TRACE(testing::Message() << (beside ? "beside" : "above") << ", hand-over " << hand_over);
            // Beside: a millimetre between the cube's side and the step's.
            auto solver = makeSolver(with(cubeAt({beside ? 0.301 : 0.05, 0.23, 0.02}), {hand_over, false}));
            advance(*solver, 60);
            const Extent extent = extentOf(*solver, 64);
            const double ground = beside ? 0.0 : 0.2;
            EXPECT_NEAR(extent.lowest, ground + 0.025, 1e-3);
            EXPECT_NEAR(extent.highest, ground + 0.175, 1e-3);
            solver->measure();
            EXPECT_LT(solver->stats().energy.kinetic, 1e-4 * solver->stats().mass);
            EXPECT_EQ(solver->stats().bonds_broken, 0u);
        }
}

/// With its middle beyond the edge it topples over it, be it moved by its bonds or as a rigid body.
TEST_F(OnABox, WhatStandsOverTheEdgeTopples) {
    for (const bool hand_over : {false, true}) {
        const auto leftAfter = [&](double x) {
            auto solver = makeSolver(with(cubeAt({x, 0.2, 0}), {hand_over, false}));
            advance(*solver, 60);
            return extentOf(*solver, 64).lowest;
        };
        EXPECT_NEAR(leftAfter(0.17), 0.225, 3e-3) << "three centimetres of the middle's side lie on it";
        EXPECT_LT(leftAfter(0.23), 0.2) << hand_over;
    }
}

/// A brick on a slope that rises against x, thrown at rest; the slope is the top of a box or a plane.
SceneSetup onSlope(double tangent, const Collider& slope) {
    const double angle = std::atan(tangent);
    SceneSetup setup = freeBody(latticeBody(6, 2, 6, 0.05));
    setup.bodies[0].material.friction = 0.5;
    setup.bodies[0].material.critical_velocity = 100;
    setup.bodies[0].rotation = {0, 0, std::sin(-angle / 2), std::cos(angle / 2)};
    setup.params.colliders = {slope};
    setup.params.gravity = {0, -9.81, 0};
    setup.params.substeps = 100;
    return setup;
}
Collider planeOf(double angle) {
    return Plane{{std::sin(angle), std::cos(angle), 0}, 0};
}
Collider boxOf(double angle) {
    constexpr double kThick = 0.5;
    return Box{{8, kThick, 8},
               {-kThick / 2 * std::sin(angle), -kThick / 2 * std::cos(angle), 0},
               {0, 0, std::sin(-angle / 2), std::cos(angle / 2)}};
}

TEST_F(OnABox, FrictionOnASlopeIsThatOfAPlane) {
    for (const double share : {0.95, 1.2}) {
        const double tangent = 0.5 * share, angle = std::atan(tangent);
        auto on_plane = makeSolver(onSlope(tangent, planeOf(angle)));
        auto on_box = makeSolver(onSlope(tangent, boxOf(angle)));
        advance(*on_plane, 30);
        advance(*on_box, 30);
        on_plane->measure();
        on_box->measure();
        const double mass = on_box->stats().mass;
        const Double3 a = on_plane->stats().linear_momentum, b = on_box->stats().linear_momentum;
        const double slides =
            9.81 * (std::sin(angle) - 0.5 * std::cos(angle)) * 0.5;  // m/s after half a second
        EXPECT_NEAR(b.x / mass, a.x / mass, 2e-3);
        EXPECT_NEAR(b.y / mass, a.y / mass, 2e-3);
        EXPECT_NEAR(std::hypot(b.x, b.y) / mass, std::max(slides, 0.0), 0.02 * std::max(slides, 0.1))
            << share;
    }
}

constexpr double kRadius = 0.1;  // m, of a ball

/// It touches the slope at the origin.
SceneSetup ballOn(const Collider& slope, double angle) {
    SceneSetup setup = freeBody(ballBody(kRadius));
    setup.bodies[0].position = {kRadius * std::sin(angle), kRadius * std::cos(angle) - kRadius, 0};
    setup.bodies[0].material.friction = 0.5;
    setup.bodies[0].material.rolling_friction = 0;
    setup.params.colliders = {slope};
    setup.params.substeps = 100;
    setup.params.step_safety = 0.1;
    return setup;
}
double speedAlong(Solver& solver, const Double3& way) {
    solver.measure();
    const Double3 p = solver.stats().linear_momentum;
    return (p.x * way.x + p.y * way.y + p.z * way.z) / solver.stats().mass;
}

TEST_F(OnABox, ABallRollsDownWithFiveSeventhsOfTheSlope) {
    const double angle = std::atan(0.3);
    SceneSetup setup = ballOn(boxOf(angle), angle);
    setup.params.gravity = {0, -9.81, 0};
    auto solver = makeSolver(setup);
    const Double3 down{std::cos(angle), -std::sin(angle), 0};
    advance(*solver, 6);
    const double first = speedAlong(*solver, down), start = solver->stats().time;
    advance(*solver, 20);
    const double expected = 5.0 / 7 * 9.81 * std::sin(angle);
    EXPECT_NEAR((speedAlong(*solver, down) - first) / (solver->stats().time - start), expected,
                0.01 * expected);
}

TEST_F(OnABox, ABallBouncesAsOnAPlane) {
    const double angle = 0.4;
    const Double3 up{std::sin(angle), std::cos(angle), 0};
    double given_back[2];
    for (const bool on_box : {false, true}) {
        SceneSetup setup = ballOn(on_box ? boxOf(angle) : planeOf(angle), angle);
        setup.bodies[0].material.restitution = 0.6;
        setup.bodies[0].position.x += 0.001 * up.x;
        setup.bodies[0].position.y += 0.001 * up.y;
        setup.bodies[0].velocity = {-2 * up.x, -2 * up.y, 0};
        auto solver = makeSolver(setup);
        advance(*solver, 6);
        given_back[on_box ? 1 : 0] = speedAlong(*solver, up) / 2;
    }
    EXPECT_NEAR(given_back[0], 0.6, 0.03);
    EXPECT_NEAR(given_back[1], given_back[0], 1e-3);
}

/// A brick comes down on an edge of the step and breaks there. While pieces in contact steps press on each
/// other books are 4 % off, on planes as well; so they are closed when little moves.
TEST_F(OnABox, TheBooksCloseThroughAnImpactOnAnEdge) {
    for (const bool hand_over : {false, true}) {
        SceneSetup setup = with(cubeAt({0.19, 0.28, 0}), {hand_over, hand_over});
        setup.bodies[0].body = latticeBody(6, 6, 6, 0.05, 0.2);
        setup.bodies[0].material = brittleMaterial();
        setup.bodies[0].rotation = {0.1, 0.2, 0.3, 0.9273618495495703};
        setup.bodies[0].position.y = 0.36;
        setup.bodies[0].velocity = {0, -3, 0};
        setup.params.substeps = 200;
        auto solver = makeSolver(setup);
        solver->measure();
        const double before = energySum(solver->stats().energy), impact = solver->stats().energy.kinetic;
        advance(*solver, hand_over ? 40 : 12);
        solver->measure();
        EXPECT_LT(std::abs(energySum(solver->stats().energy) - before) / impact, 0.02) << hand_over;
        EXPECT_GT(solver->stats().bonds_broken, 0.1 * solver->stats().bonds);
    }
}

TEST_F(OnABox, WhatRestsOnItSleepsUntilItIsHit) {
    SceneSetup setup = with(cubeAt({0, 0.201, 0}), {true, true});
    setup.bodies[0].material = brittleMaterial();
    Projectile ball;
    ball.radius = 0.04;
    ball.position = {-0.9, 0.34, 0.003};
    ball.velocity = {9, 0, 0};
    auto solver = makeSolver(setup);
    advance(*solver, 45);
    EXPECT_EQ(solver->stats().sleeping_fragments, 1u);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    const uint64_t asleep = solver->stateHash();
    advance(*solver, 10);
    EXPECT_EQ(solver->stateHash(), asleep) << "it sleeps on";
    solver->fire(ball);
    advance(*solver, 12);
    EXPECT_GT(solver->stats().bonds_broken, 0u);
}

/// Bonds that rest wake before a hard landing on a box as on a plane.
TEST_F(OnABox, ABodyThatFallsOntoItWakes) {
    SceneSetup setup = with(cubeAt({0, 0.7, 0}), {true, true});
    setup.bodies[0].material = brittleMaterial();
    setup.bodies[0].material.critical_velocity = 9;  // so that the landing wakes it and breaks nothing
    auto solver = makeSolver(setup);
    bool was_rigid = false, woke = false;
    while (solver->stats().time < 0.5) {
        advance(*solver, 1);
        was_rigid = was_rigid || solver->stats().bonded_particles == 0;
        woke = woke || (was_rigid && solver->stats().bonded_particles > 0);
    }
    EXPECT_TRUE(woke);
    EXPECT_EQ(solver->stats().bonds_broken, 0u);
    EXPECT_GT(extentOf(*solver, 64).lowest, 0.22) << "it bounces";
}

}  // namespace
}  // namespace demolish::tests
