// SPDX-License-Identifier: Apache-2.0
// What the solver makes of a set-up, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/solver/scene_tables.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

TEST(SolverSetup, RowsHoldEveryBondTwiceAndSorted) {
    SceneSetup setup = freeBody(latticeBody(3, 4, 2, 0.1, 0.2));
    setup.bodies.push_back(setup.bodies[0]);
    const SceneTables tables = buildSceneTables(setup, {});
    const size_t bonds = setup.bodies[0].body->bonds.size();
    ASSERT_EQ(tables.slots.size(), 4 * bonds);
    ASSERT_EQ(tables.slot_of_bond.size(), 2 * bonds);
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i)
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s) {
            const uint32_t t = tables.twin[s];
            if (s > tables.row_start[i]) {
                EXPECT_LT(tables.slots[s - 1].other, tables.slots[s].other);
            }
            EXPECT_EQ(tables.twin[t], s);
            EXPECT_EQ(tables.slots[t].other, i);
            EXPECT_EQ(tables.slots[t].rest.x, -tables.slots[s].rest.x);
            EXPECT_EQ(tables.owner[i], tables.owner[tables.slots[s].other]);
        }
    for (size_t b = 0; b < bonds; ++b)
        EXPECT_EQ(tables.slots[tables.slot_of_bond[b]].other, setup.bodies[0].body->bonds[b].j);
}

TEST(SolverSetup, NoBodyIsStifferThanItsMaterial) {
    const auto modulus = [](double edge, uint32_t substeps) {
        SceneSetup setup = freeBody(latticeBody(1, 2, 1, edge));
        setup.params.substeps = substeps;
        return buildSceneTables(setup, {}).body[0].report.effective_modulus;
    };
    const double real = freeBody(latticeBody(1, 2, 1, 1)).bodies[0].material.youngs_modulus;
    EXPECT_NEAR(modulus(20, 422), real, 1e-9 * real) << "its step would bear 4000 times as much";
    EXPECT_LT(modulus(0.05, 422), 0.1 * real);
}

TEST(SolverSetup, ContactRadiiNeverOverlapAtRest) {
    const auto body = latticeBody(5, 4, 6, 0.1, 0.3);
    const auto radii = contactRadii(*body);
    for (size_t i = 0; i < radii.size(); ++i)
        for (size_t j = 0; j < i; ++j) {
            const Double3 a = body->particles[i].seed, b = body->particles[j].seed;
            EXPECT_LE(radii[i] + radii[j], std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) * (1 + 1e-12));
        }
}

/// Of a slender cell, whose neighbours are far, a ball as far as half way to them would stick out.
TEST(SolverSetup, ContactRadiiAreThoseOfTheCellsVolumeAtMost) {
    constexpr double kRadius = 0.02;
    BreakableBody body = *latticeBody(1, 1, 5, 0.1);
    for (Particle& particle : body.particles) particle.volume = 4.0 / 3 * kPi * kRadius * kRadius * kRadius;
    for (const double radius : contactRadii(body)) EXPECT_NEAR(radius, kRadius, 1e-12);
}

TEST(SolverSetup, CellsReachTowardsCollidersAsFarAsTheirCorners) {
    const auto body = latticeBody(4, 3, 4, 0.1, 0.2);
    const auto radii = floorRadii(*body);
    for (size_t i = 0; i < radii.size(); ++i) {
        const Particle& p = body->particles[i];
        const auto farthest = [](double seed, double centroid) { return std::abs(seed - centroid) + 0.05; };
        EXPECT_NEAR(radii[i],
                    std::hypot(farthest(p.seed.x, p.centroid.x), farthest(p.seed.y, p.centroid.y),
                               farthest(p.seed.z, p.centroid.z)),
                    1e-12);
    }
    auto spheres = *body;
    spheres.corners = {};
    EXPECT_EQ(floorRadii(spheres)[5], std::min(body->particles[5].depth, std::cbrt(0.75e-3 / kPi)));
}

TEST(SolverSetup, BodiesOfOneShapeShareTheirCorners) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position.x = 1;
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[2].body = latticeBody(1, 1, 2, 0.1);
    setup.bodies[2].position.x = 2;
    const SceneTables tables = buildSceneTables(setup, {});
    ASSERT_EQ(tables.corner_row.size(), 18u);
    EXPECT_EQ(tables.corner.size(), 8u * (8 + 2));
    EXPECT_EQ(tables.corner_row[9].first, tables.corner_row[1].first);
    EXPECT_EQ(tables.corner_row[16].first, 64u);
    EXPECT_EQ(tables.corner_row[17].last, 80u);
}

TEST(SolverSetup, StrengthFollowsTheArtistsNumber) {
    SceneSetup setup = freeBody(latticeBody(5, 5, 5, 0.1));
    setup.bodies[0].material.critical_velocity = 4;
    const SofteningReport once = makeCpuSolver(setup)->softening();
    setup.bodies[0].material.critical_velocity = 8;
    const SofteningReport twice = makeCpuSolver(setup)->softening();
    EXPECT_NEAR(twice.strength / once.strength, 2, 1e-12);
    EXPECT_NEAR(once.strength, 0.4 * 2400 * once.wave_speed * 4, 1e-6 * once.strength);
    EXPECT_NEAR(once.effective_modulus, 2400 * once.wave_speed * once.wave_speed,
                1e-6 * once.effective_modulus);
    EXPECT_NEAR(once.strain_at_failure, once.strength / once.effective_modulus, 1e-12);
}

TEST(SolverSetup, MassDoesNotDependOnParticleSize) {
    const auto mass = [](uint32_t n) {
        return makeCpuSolver(freeBody(latticeBody(n, n, n, 0.4 / n)))->stats().mass;
    };
    EXPECT_NEAR(mass(2), mass(5), 1e-9 * mass(2));
}

TEST(SolverSetup, WhatCannotBeSimulatedIsRefused) {
    const auto refused = [](auto change) {
        SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
        change(setup);
        EXPECT_THROW(makeCpuSolver(setup), UsageError);
    };
    refused([](SceneSetup& s) { s.bodies.clear(); });
    refused([](SceneSetup& s) { s.bodies[0].material.density = -1; });
    refused([](SceneSetup& s) { s.bodies[0].velocity.x = std::nan(""); });
    refused([](SceneSetup& s) { s.params.substeps = 0; });
    refused([](SceneSetup& s) { s.params.colliders.resize(kMaxColliders + 1); });
    refused([](SceneSetup& s) { s.projectiles.resize(kMaxProjectiles + 1); });
    refused([](SceneSetup& s) { s.projectiles.push_back({{}, {}, -1, 7800, 3, 0}); });
}

/// The sentence with which a set-up with these colliders is refused; empty when it is taken.
std::string refusalOf(const std::vector<Collider>& colliders) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position = {0.5, 0, 0};
    setup.params.colliders = colliders;
    try {
        makeCpuSolver(setup);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SolverSetup, ABadBoxIsRefusedWithASentence) {
    const Box aside{{0.1, 0.1, 0.1}, {3, 0, 0}, {}};
    const auto refusedAs = [&](auto change) {
        Box box = aside;
        change(box);
        return refusalOf({box});
    };
    EXPECT_EQ(refusalOf({aside}), "");
    EXPECT_EQ(refusedAs([](Box& b) { b.size.y = 0; }),
              "An edge (m) of a box is 0.000000, it must lie between 0.001000 and 10000.000000.");
    EXPECT_NE(refusedAs([](Box& b) { b.size.x = -1; }), "");
    EXPECT_NE(refusedAs([](Box& b) { b.size.z = std::nan(""); }), "");
    EXPECT_NE(refusedAs([](Box& b) { b.size.z = 1e300 * 1e300; }), "");
    EXPECT_EQ(refusedAs([](Box& b) { b.position.z = std::nan(""); }),
              "A box's position is not a finite number.");
    EXPECT_NE(refusedAs([](Box& b) { b.rotation.w = 2; }), "");
    EXPECT_NE(refusedAs([](Box& b) { b.rotation.x = std::nan(""); }), "");
    EXPECT_EQ(refusalOf(std::vector<Collider>(kMaxColliders + 1, aside)),
              "A scene has at most 8 colliders, its floor among them.");
    EXPECT_EQ(refusalOf(std::vector<Collider>(kMaxColliders, aside)), "");
}

TEST(SolverSetup, BadRoundCollidersAreRefusedWithASentence) {
    const double nan = std::nan("");
    EXPECT_EQ(refusalOf({Sphere{0.1, {3, 0, 0}}, Capsule{0.1, {3, 0, 0}, {3, 1, 0}}}), "");
    EXPECT_EQ(refusalOf({Sphere{0, {3, 0, 0}}}),
              "The radius (m) of a sphere is 0.000000, it must lie between 0.001000 and 10000.000000.");
    EXPECT_EQ(refusalOf({Sphere{0.1, {nan, 0, 0}}}), "A sphere's position is not a finite number.");
    EXPECT_EQ(refusalOf({Capsule{2e4, {3, 0, 0}, {3, 1, 0}}}),
              "The radius (m) of a capsule is 20000.000000, it must lie between 0.001000 and 10000.000000.");
    EXPECT_EQ(refusalOf({Capsule{0.1, {3, 0, 0}, {3, nan, 0}}}),
              "An end of a capsule is not a finite number.");
    EXPECT_EQ(refusalOf({Capsule{0.1, {3, 0, 0}, {3, 0, 0}}}),
              "The length (m) of a capsule between its ends is 0.000000, it must lie between 0.001000 and "
              "10000.000000.");
    Collider rough = Plane{};
    rough.friction = 2;
    EXPECT_NE(refusalOf({rough}), "");
    Collider bouncy = Plane{};
    bouncy.restitution = 0;
    EXPECT_NE(refusalOf({bouncy}), "");
}

TEST(SolverSetup, ABodyThatStartsInsideAColliderIsRefused) {
    EXPECT_EQ(refusalOf({Plane{}, Sphere{0.1, {0.5, 0.1, 0}}}),
              "Body 1 of the scene starts inside its collider 1, a sphere (bodies are counted from 0, and "
              "collider 0 is the floor); move one of them.");
    EXPECT_EQ(refusalOf({Plane{}, Capsule{0.1, {0.5, 0.1, -3}, {0.5, 0.1, 3}}}),
              "Body 1 of the scene starts inside its collider 1, a capsule (bodies are counted from 0, and "
              "collider 0 is the floor); move one of them.");
    EXPECT_EQ(refusalOf({Plane{}, Box{{0.4, 0.2, 0.4}, {0.5, -0.1, 0}, {}}}), "") << "it stands on it";
    EXPECT_EQ(refusalOf({Plane{}, Box{{0.1, 0.2, 0.4}, {0.5, 0, 0}, {}}}),
              "Body 1 of the scene starts inside its collider 1, a box (bodies are counted from 0, and "
              "collider 0 is the floor); move one of them.");
    EXPECT_EQ(refusalOf({Plane{{0, 1, 0}, 0.06}}),
              "Body 0 of the scene starts inside its collider 0, a plane (bodies are counted from 0, and "
              "collider 0 is the floor); move one of them.");
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    setup.params.colliders = {Plane{}, Box{}};
    EXPECT_THROW(makeCpuSolver(setup), InputFileError);
}

TEST(SolverSetup, AProjectileThatStartsInsideAColliderIsRefused) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    setup.params.colliders = {Box{{1, 1, 1}, {3, 0, 0}, {}}};
    Projectile ball;
    ball.position = {3.2, 0.1, 0};
    auto solver = makeCpuSolver(setup);
    EXPECT_THROW(solver->fire(ball), UsageError);
    setup.projectiles = {ball};
    EXPECT_THROW(makeCpuSolver(setup), UsageError);
}

TEST(SolverSetup, CancellingEndsInCancelled) {
    SceneSetup setup = freeBody(latticeBody(2, 2, 2, 0.1));
    EXPECT_THROW(makeCpuSolver(setup, [](double, const char*) { return false; }), Cancelled);
    setup.params.settle_time = 0.1;
    const auto until_settling = [](double, const char* stage) { return std::string(stage) != "Settling"; };
    EXPECT_THROW(makeCpuSolver(setup, until_settling), Cancelled);
}

TEST(SolverSetup, TheCudaSolverSaysWhenThereIsNoGpu) {
    const CudaDevice device = findCudaDevice();
    if (device.usable) GTEST_SKIP() << "this machine has " << device.name;
    EXPECT_FALSE(device.problem.empty());
    EXPECT_THROW(makeCudaSolver(freeBody(latticeBody(2, 2, 2, 0.1))), DeviceError);
}

}  // namespace
}  // namespace demolish::tests
