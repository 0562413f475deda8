// SPDX-License-Identifier: Apache-2.0
// Stiffness of packed bars of spheres that are bonded across their gaps by the paper's law (physics.md D 14,
// A.3).
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/contact_laws.h"
#include "tests/physics/models/bar_wave.h"
#include "tests/physics/models/packed_spheres.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

struct Measured {
    double modulus = 0;  ///< E_eff / E
    double bonds = 0;    ///< z
};

/// E_eff = rho_bulk c^2 of a bar 1 x .25 x .25 of spheres of 0.043 m, with a_b = 2 a* R*.
Measured sphereBar(double ratio, double gap, uint64_t seed) {
    const PackedSpheres packing = packSpheres({0.25, 0.25, 1}, 0.043, gap, seed);
    SceneSetup setup = freeBody(packing.body);
    Material& material = setup.bodies[0].material;
    material.bond_law = BondLaw::kPaper;
    material.density = 3900;
    material.tough_cells = 0;
    SceneTables tables = buildSceneTables(setup, {});
    const double E = tables.body[0].report.bond_modulus;
    double mass = 0;
    for (uint32_t i = 0; i < tables.counts.in_bodies; ++i) {
        mass += tables.mass[i];
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s) {
            BondSlot& slot = tables.slots[s];
            slot.radius = sphereBondRadius(ratio, packing.radius[i], packing.radius[slot.other]);
            slot.stiffness = paperBond(E, material.poisson_ratio, ratio, slot.radius).normal;
        }
    }
    for (const BondSlot& slot : tables.slots)
        tables.body[0].largest_radius = std::max(tables.body[0].largest_radius, slot.radius);
    const double speed = ringBar(setup, tables, {0, 0, 1}, 1).speed;
    return {mass / packing.volume * speed * speed / E, packing.bonds_per_particle};
}

class SphereBar : public OnEitherDevice {};

TEST_F(SphereBar, ModulusFollowsTheNumberOfBondsAParticle) {  // D 14
    // A bar cut from a packing has fewer bonds at its sides, so that a wider gap is needed for the same z.
    const Measured usual = sphereBar(0.5, 0.20, 1), many = sphereBar(0.5, 0.28, 1);
    EXPECT_NEAR(usual.bonds, 7.5, 0.2);
    EXPECT_NEAR(usual.modulus, 0.55, 0.03);
    EXPECT_NEAR(many.bonds, 8.5, 0.2);
    EXPECT_NEAR(many.modulus, 0.66, 0.05);  // measured 0.614; the sheet's bar had z = 8.5 at a gap of 0.20
}

TEST_F(SphereBar, WideNecksAreAsStiffAsTheMaterial) {  // D 14
    const Measured wide = sphereBar(0.7, 0.20, 1);
    EXPECT_NEAR(wide.bonds, 7.5, 0.2);
    EXPECT_NEAR(wide.modulus, 1.0, 0.06);
}

}  // namespace
}  // namespace demolish::tests
