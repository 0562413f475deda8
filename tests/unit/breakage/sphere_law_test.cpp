// SPDX-License-Identifier: Apache-2.0
// The paper's bonds between spheres in the solver's tables: (5)-(10), (13), walls, and the real stiffness.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/sphere_specimen.h"
#include "sim_cuda/physics/scalar.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish::tests {
namespace {

/// Two spheres of radii a and b (m) in touch along x.
std::shared_ptr<const BreakableBody> pairOfSpheres(double a, double b) {
    auto body = std::make_shared<BreakableBody>();
    for (const double radius : {a, b}) {
        Particle grain;
        grain.volume = 4.0 / 3 * kPi * radius * radius * radius;
        grain.contact_radius = radius;
        body->particles.push_back(grain);
    }
    body->particles[1].seed = body->particles[1].centroid = {a + b, 0, 0};
    BondGeometry bond;
    bond.j = 1;
    const double neck = a * b / (a + b);  // 2 a* R* at a* = 0.5
    bond.area = kPi * neck * neck;
    bond.normal = {1, 0, 0};
    bond.length = a + b;
    body->bonds.push_back(bond);
    body->spacing = a + b;
    return body;
}

/// One body above the floor.
SceneSetup sphereScene(std::shared_ptr<const BreakableBody> body) {
    SceneSetup setup;
    BodyInstance instance;
    instance.body = std::move(body);
    instance.position.y = 1e-3;
    instance.material.bond_law = BondLaw::kSpheres;
    instance.material.youngs_modulus = 200e9;
    instance.material.fracture_energy = 30;
    instance.material.tough_cells = 0;
    setup.bodies = {instance};
    setup.params.soften = false;
    setup.params.frame_time = 1e-8;
    setup.params.contact_law = ContactLaw::kHertz;
    return setup;
}

TEST(SphereBonds, HaveTheReferenceStiffnessAndStrength) {  // physics D.7 and D.9
    const SceneTables tables = buildSceneTables(sphereScene(pairOfSpheres(1e-6, 1e-6)), {});
    ASSERT_EQ(tables.slots.size(), 2u);
    const BondSlot& slot = tables.slots[0];
    EXPECT_NEAR(slot.radius, 5e-7, 1e-12);
    EXPECT_NEAR(slot.stiffness, 1.5284e5, 1.5284e5 * 1e-4);
    EXPECT_NEAR(slot.stiffness * tables.body[0].shear_ratio, 1.3100e5, 1.31e5 * 1e-4);
    EXPECT_NEAR(slot.stiffness * slot.radius * slot.radius / 4, 9.5523e-9, 9.5523e-9 * 1e-4);
    EXPECT_NEAR(tables.body[0].report.strength * slot.strength, 2.01851e9, 2.01851e9 * 1e-4);
    EXPECT_EQ(tables.body[0].report.bond_modulus, 200e9);
}

TEST(SphereBonds, AreTheStrongerTheSmallerTheyAre) {
    SceneSetup setup = sphereScene(pairOfSpheres(1e-6, 1e-6));
    setup.bodies.push_back(sphereScene(pairOfSpheres(4e-6, 4e-6)).bodies[0]);
    const SceneTables tables = buildSceneTables(setup, {});
    const auto strength = [&](size_t body) {
        return tables.body[body].report.strength * tables.slots[2 * body].strength;
    };
    EXPECT_NEAR(strength(0), 2 * strength(1), 1e-6 * strength(0));
}

TEST(SphereBonds, OfOneBodyDifferByTheirOwnRadii) {
    const auto body = packSphereSpecimen({.grains = 80, .seed = 2});
    const SceneTables tables = buildSceneTables(sphereScene(body), {});
    for (size_t b = 0; b < body->bonds.size(); ++b) {
        const BondSlot& slot = tables.slots[tables.slot_of_bond[b]];
        const double neck = std::sqrt(body->bonds[b].area / kPi);
        const double strength = std::sqrt(200e9 * 30 / ((1 - 0.0625) * kPi * neck));
        EXPECT_NEAR(tables.body[0].report.strength * slot.strength, strength, 1e-9 * strength);
    }
}

TEST(SphereBonds, TheStepFollowsTheRealStiffness) {
    const auto body = packSphereSpecimen({.grains = 80, .seed = 2});
    SceneSetup setup = sphereScene(body);
    setup.bodies.push_back(setup.bodies[0]);  // the same body once more
    const SceneTables tables = buildSceneTables(setup, {});
    EXPECT_EQ(tables.body[0].report.highest_frequency, tables.body[1].report.highest_frequency);
    EXPECT_LE(tables.time_step, 1.0 / tables.body[0].report.highest_frequency * (1 + 1e-12));
    setup.bodies[1].material.density *= 4;  // slower: it must not be taken for the same
    const SceneTables slower = buildSceneTables(setup, {});
    EXPECT_NEAR(slower.body[1].report.highest_frequency, tables.body[0].report.highest_frequency / 2,
                1e-6 * tables.body[0].report.highest_frequency);
}

TEST(SphereWalls, TakeTheirOwnFrictionAndStiffness) {
    SceneSetup setup = sphereScene(pairOfSpheres(1e-6, 1e-6));
    const SceneTables tables = buildSceneTables(setup, {});
    const auto rigid = buildLawTables(setup, tables, {}).wall[0];
    EXPECT_NEAR(rigid.modulus, 200e9 / (1 - 0.0625), 1);
    EXPECT_EQ(rigid.friction, setup.bodies[0].material.friction);
    setup.params.wall_friction = 0;
    setup.params.wall_stiffness = 0.5;
    const auto printed = buildLawTables(setup, tables, {}).wall[0];
    EXPECT_EQ(printed.modulus, rigid.modulus / 2);
    EXPECT_EQ(printed.shear_modulus, rigid.shear_modulus / 2);
    EXPECT_EQ(printed.friction, 0);
    setup.params.wall_friction = 7;
    EXPECT_THROW(checkSetup(setup), UsageError);
}

}  // namespace
}  // namespace demolish::tests
