// SPDX-License-Identifier: Apache-2.0
// Specimens of packed spheres: the statistics that physics C.1 gives, and what may never be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/sphere_specimen.h"
#include "sim_cuda/physics/scalar.h"

namespace demolish::tests {
namespace {

double distance(const Double3& a, const Double3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}
double radiusOf(const Particle& grain) {
    return std::cbrt(3 * grain.volume / (4 * kPi));
}

TEST(Specimen, HasTheSolidFractionAndTheBondsOfTheExperiment) {
    double bonds = 0, deepest = 0;
    constexpr int kPackings = 4;
    for (uint64_t seed = 1; seed <= kPackings; ++seed) {
        const auto body = packSphereSpecimen({.seed = seed});
        ASSERT_EQ(body->particles.size(), 500u);
        EXPECT_NEAR(body->cells_volume / (kPi / 6 * std::pow(24e-6, 3)), 0.60, 1e-9);
        double smallest = 1, largest = 0;
        for (const Particle& grain : body->particles) {
            const double radius = radiusOf(grain);
            smallest = std::min(smallest, radius);
            largest = std::max(largest, radius);
            deepest = std::max(deepest, 1 - grain.contact_radius / radius);
            EXPECT_LT(distance(grain.seed, {}) + radius, 12e-6 + 0.08 * radius);  // pressed into the rim
        }
        EXPECT_NEAR(largest / smallest, 1.12 / 0.88, 0.01);
        bonds += coordinationOf(*body) / kPackings;
    }
    EXPECT_NEAR(bonds, 8.5, 0.35);
    EXPECT_LT(deepest, 0.04) << "the packing left too much overlap";
}

TEST(Specimen, IsBondedWhereverTheGapAllowsAndNowhereElse) {
    const SphereSpecimen values{.grains = 120, .seed = 3};
    const auto body = packSphereSpecimen(values);
    size_t next = 0;
    for (uint32_t i = 0; i < body->particles.size(); ++i)
        for (uint32_t j = i + 1; j < body->particles.size(); ++j) {
            const Particle &a = body->particles[i], &b = body->particles[j];
            const double r_a = radiusOf(a), r_b = radiusOf(b), apart = distance(a.seed, b.seed);
            EXPECT_LE(a.contact_radius + b.contact_radius, apart * (1 + 1e-12));
            if (apart > 1.2 * (r_a + r_b)) continue;
            ASSERT_LT(next, body->bonds.size());
            const BondGeometry& bond = body->bonds[next++];
            EXPECT_EQ(bond.i, i);
            EXPECT_EQ(bond.j, j);
            EXPECT_NEAR(bond.length, apart, 1e-12 * apart);
            const double neck = 2 * values.bond_ratio * r_a * r_b / (r_a + r_b);
            EXPECT_NEAR(bond.area, kPi * neck * neck, 1e-9 * bond.area);
        }
    EXPECT_EQ(next, body->bonds.size());
}

TEST(Specimen, IsTheSameForTheSameSeedAlone) {
    const auto once = packSphereSpecimen({.grains = 60, .seed = 5});
    const auto again = packSphereSpecimen({.grains = 60, .seed = 5});
    const auto other = packSphereSpecimen({.grains = 60, .seed = 6});
    for (size_t i = 0; i < 60; ++i) EXPECT_EQ(once->particles[i].seed.x, again->particles[i].seed.x);
    EXPECT_NE(once->particles[0].seed.x, other->particles[0].seed.x);
}

TEST(Specimen, HasNoPreferredDirection) {
    // Mean of n n^T over the bonds: 1/3 each way for an isotropic packing; 3 standard deviations of 8
    // packings.
    double along[3] = {};
    size_t bonds = 0;
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        const auto body = packSphereSpecimen({.grains = 200, .seed = seed});
        for (const BondGeometry& bond : body->bonds) {
            along[0] += bond.normal.x * bond.normal.x;
            along[1] += bond.normal.y * bond.normal.y;
            along[2] += bond.normal.z * bond.normal.z;
            ++bonds;
        }
    }
    for (const double sum : along)
        EXPECT_NEAR(sum / static_cast<double>(bonds), 1.0 / 3,
                    3 * 0.3 / std::sqrt(static_cast<double>(bonds)));
}

TEST(Specimen, RefusesWhatCannotBePacked) {
    EXPECT_THROW(packSphereSpecimen({.grains = 1}), UsageError);
    EXPECT_THROW(packSphereSpecimen({.solid_fraction = 0.7}), UsageError);
    EXPECT_THROW(packSphereSpecimen({.diameter = 0}), UsageError);
    EXPECT_THROW(packSphereSpecimen({.bond_ratio = 1}), UsageError);
}

}  // namespace
}  // namespace demolish::tests
