// SPDX-License-Identifier: Apache-2.0
// Substeps, places of bodies and drops, checked by the mechanics they promise.
#include "app/session/shot_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/session/built_shot.h"
#include "app/session/scene_file.h"
#include "app/session/shot_bodies.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/grid_cube.h"

namespace demolish {
namespace {

SceneBody standing(const Double3& position, double yaw, uint32_t variant) {
    SceneBody body;
    body.position = position;
    body.yaw = yaw;
    body.variant = variant;
    return body;
}

using test::gridCube;

TEST(ShotSetup, SubstepsGoAsOneOverTheParticleSize) {
    Shot shot;
    shot.wave_speed = 91;
    BreakableBody body;
    body.bounds_max.y = 0.33;
    body.spacing = 0.0149;
    EXPECT_NEAR(substepsFor(shot, body, 0.5), 300, 3);  // models.md E.3, draft
    body.spacing = 0.0079;
    EXPECT_NEAR(substepsFor(shot, body, 0.5), 565, 6);  // and full
    shot.substeps = 123;
    EXPECT_EQ(substepsFor(shot, body, 0.5), 123u);
}

TEST(ShotSetup, ADroppedBodyReachesTheFloorWithTheChosenVelocity) {
    Shot shot;
    shot.impact.kind = ImpactKind::kDrop;
    for (const double velocity : {0.5, 3.0, 12.0}) {
        shot.impact.velocity = velocity;
        const auto body = std::make_shared<BreakableBody>(gridCube(8));
        const SceneSetup setup = makeSetup(shot, {body});
        const BodyInstance& instance = setup.bodies.at(0);
        double lowest = 1e9;
        for (const auto& particle : body->particles)
            lowest = std::min(lowest, particle.seed.y - particle.depth);
        const double gap = instance.position.y + lowest;
        EXPECT_GE(gap, 0);
        EXPECT_NEAR(std::sqrt(instance.velocity.y * instance.velocity.y + 2 * 9.81 * gap), velocity, 1e-9);
        EXPECT_LE(instance.velocity.y, 0);
    }
}

TEST(ShotSetup, ASceneIsLargeEnoughForItsBodiesUnlessItSaysHowLarge) {
    Shot shot;
    const auto radius = [&shot](double height) {
        auto body = std::make_shared<BreakableBody>(gridCube(8));
        body->bounds_min = {0, 0, 0};
        body->bounds_max = {0, height, 0};
        return makeSetup(shot, {body}).params.scene_radius;
    };
    EXPECT_EQ(radius(1), 1000);
    EXPECT_GE(radius(2000), 8000);
    shot.scene_radius = 5;
    EXPECT_EQ(radius(2000), 5);
}

TEST(ShotSetup, WithoutASceneTheStiffnessFollowsStrengthAndWeight) {
    Shot shot;
    shot.material.critical_velocity = 2.5;
    shot.material.beta = 0.4;
    EXPECT_NEAR(wantedWaveSpeed(shot, 0.1), 91, 1);  // strain 0.011 at failure
    EXPECT_GT(wantedWaveSpeed(shot, 2.0), 200);      // a tall body must carry itself
}

/// A cube of 4^3 particles with one bond that is so many spacings long.
std::shared_ptr<const BreakableBody> bondedCube(double length) {
    auto body = std::make_shared<BreakableBody>(gridCube(4));
    BondGeometry bond;
    bond.j = 1;
    bond.area = body->spacing * body->spacing;
    bond.length = length * body->spacing;
    bond.normal = {1, 0, 0};
    body->bonds = {bond};
    return body;
}

/// By the strain of beta v_c / (kappa safety 60 h n) at failure; bonds stay as soft as n substeps make them.
TEST(ShotSetup, RubberAndLongCellsHaveTheirSubstepsDividedInTwo) {
    Shot shot;
    shot.material.critical_velocity = 50;
    shot.material.beta = 0.4;
    const auto paramsOf = [&shot](uint32_t substeps, double length) {
        shot.substeps = substeps;
        return makeSetup(shot, {bondedCube(length)}).params;
    };
    const double at_limit = 0.4 * 50 / (0.1 * 0.68 * 0.5 * 60 * 0.25);
    const auto few = static_cast<uint32_t>(std::floor(at_limit)), enough = few + 1;
    EXPECT_EQ(paramsOf(enough, 1).substeps, enough);
    EXPECT_EQ(paramsOf(enough, 1).step_safety, 0.5);
    EXPECT_EQ(paramsOf(few, 1).substeps, 2 * few);
    EXPECT_EQ(paramsOf(few, 1).step_safety, 0.25);
    EXPECT_EQ(paramsOf(enough, 5.9).substeps, enough);
    EXPECT_EQ(paramsOf(enough, 6.1).substeps, 2 * enough);
    EXPECT_EQ(paramsOf(enough, 6.1).step_safety, 0.25);
    shot.material.critical_velocity = 1e6;
    EXPECT_EQ(paramsOf(few, 1).substeps, few) << "it is not meant to break";
}

/// Whatever moves them, and however they fall.
TEST(ShotSetup, SubstepsAreDividedUntilNothingComesFarInOne) {
    constexpr double kFarthest = 0.1;
    const double spacing = bondedCube(1)->spacing;
    Shot shot;
    shot.material.critical_velocity = 1e6;
    const auto expectFine = [&](const Shot& of, double speed) {
        const SolverParams params = makeSetup(of, {bondedCube(1)}).params;
        const double far = speed / (60.0 * params.substeps) / spacing;
        EXPECT_LE(far, kFarthest);
        EXPECT_EQ(params.substeps % *of.substeps, 0u);
        EXPECT_DOUBLE_EQ(params.substeps * params.step_safety, 0.5 * *of.substeps) << "as soft";
        return params.substeps / *of.substeps;
    };
    for (const uint32_t substeps : {1u, 7u, 100u, 20000u})
        for (const double speed : {0.5, 20.0, 200.0}) {
            SCOPED_TRACE(std::to_string(substeps) + " substeps, " + std::to_string(speed) + " m/s");
            Shot ball = shot;
            ball.substeps = substeps;
            ball.impact.velocity = speed;
            const uint32_t steps = expectFine(ball, speed);
            if (speed < 0.1 * kFarthest * spacing * 60 * substeps) {
                EXPECT_EQ(steps, 1u);
            }
            Shot small = ball;
            small.impact.ball_radius = 0.01 * spacing;
            const SolverParams params = makeSetup(small, {bondedCube(1)}).params;
            if (params.substeps + substeps <= kSubstepRange.most) {
                EXPECT_LE(speed / (60.0 * params.substeps), small.impact.ball_radius / 3);
            }
            Shot dropped = ball;
            dropped.impact.kind = ImpactKind::kDrop;
            expectFine(dropped, speed);
            Shot thrown = ball;
            thrown.impact.velocity = 0;
            thrown.bodies = {standing({0, 0, 0}, 0, 0)};
            thrown.bodies[0].velocity = {0, 0, speed};
            expectFine(thrown, speed);
            thrown.bodies[0] = standing({0, 1000, 0}, 0, 0);
            expectFine(thrown, std::sqrt(2 * 9.81 * 1000));
        }
}

/// One substep that a fast ball of a millimetre divides by as much as there may be.
TEST(ShotSetup, WhatIsDividedByTheMostIsStillSimulated) {
    Shot shot;
    shot.substeps = 1;
    shot.impact.velocity = 200;
    shot.impact.ball_radius = 1e-4;
    const SceneSetup setup = makeSetup(shot, {std::make_shared<BreakableBody>(gridCube(2))});
    EXPECT_EQ(setup.params.substeps, kSubstepRange.most);
    EXPECT_NO_THROW(makeCpuSolver(setup));
}

TEST(ShotSetup, BodiesStandWhereTheSceneSaysAtEveryHeight) {
    Shot shot;
    shot.bodies = {standing({0, 0, 0}, 0, 0), standing({3, 0, -1}, std::numbers::pi / 2, 1)};
    const auto first = std::make_shared<BreakableBody>(gridCube(4)),
               second = std::make_shared<BreakableBody>(gridCube(5));
    for (const double height : {1.0, 2.5}) {
        shot.height = height;
        const SceneSetup setup = makeSetup(shot, {first, second});
        ASSERT_EQ(setup.bodies.size(), 2u);
        EXPECT_EQ(setup.bodies[0].body, first);
        EXPECT_EQ(setup.bodies[1].body, second);
        EXPECT_DOUBLE_EQ(setup.bodies[1].position.x, 3 * height);
        EXPECT_DOUBLE_EQ(setup.bodies[1].position.z, -height);
        EXPECT_NEAR(setup.bodies[1].rotation.y, std::sqrt(0.5), 1e-12);
        EXPECT_NEAR(setup.bodies[1].rotation.w, std::sqrt(0.5), 1e-12);
    }
}

TEST(ShotSetup, TheBoxHoldsAllBodiesTurned) {
    const auto plank = std::make_shared<BreakableBody>();  // 2 x 1 x 0.2 m
    plank->bounds_min = {-1, 0, -0.1};
    plank->bounds_max = {1, 1, 0.1};
    Shot shot;
    shot.bodies = {standing({-4, 0, 0}, 0, 0), standing({0, 0, 5}, std::numbers::pi / 2, 0)};
    const SceneBox box = sceneBox(shot, {plank, plank});
    EXPECT_NEAR(box.low.x, -5, 1e-12);
    EXPECT_NEAR(box.high.x, 0.1, 1e-12);
    EXPECT_NEAR(box.low.z, -0.1, 1e-12);
    EXPECT_NEAR(box.high.z, 6, 1e-12);
    EXPECT_NEAR(box.high.y, 1, 1e-12);
}

TEST(ShotSetup, BodiesAreCountedTogether) {
    Shot shot = loadScene("vase");
    const auto mesh = loadSolidMesh(shot.model, {.height = shot.height});
    shot.fineness.particles = 100'000;
    EXPECT_EQ(particlesWanted(shot, *mesh, false), 100'000u);
    requireFewEnough(std::vector<uint32_t>(20, 100'000));
    shot.fineness.particles = kMaxParticles;
    try {
        prepareShot(shot, {.draw_geometry = false}, {});
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("20 bodies of 4000000 particles are 80000000"));
    }
    shot.bodies.clear();
    EXPECT_EQ(particlesWanted(shot, *mesh, false), kMaxParticles);
}

TEST(ShotSetup, EveryBodyOfADropFalls) {
    Shot shot;
    shot.impact.kind = ImpactKind::kDrop;
    shot.impact.velocity = 3;
    shot.bodies = {standing({0, 0, 0}, 0, 0), standing({2, 0, 0}, 1.0, 0)};
    const auto body = std::make_shared<BreakableBody>(gridCube(4));
    const SceneSetup setup = makeSetup(shot, {body, body});
    for (const BodyInstance& instance : setup.bodies) {
        EXPECT_LT(instance.velocity.y, -1);
        EXPECT_GT(instance.position.y, 0.1);
    }
}

}  // namespace
}  // namespace demolish
