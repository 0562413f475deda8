// SPDX-License-Identifier: Apache-2.0
// Constants of the solid bond: physics D 7, D 8, the table of f_N, ranges, dimensions, the beam law of models
// E.1.
#include "sim_cuda/physics/bond_stiffness.h"

#include <gtest/gtest.h>

#include "tests/physics/laws/laws.h"

namespace demolish {
namespace {

TEST(PaperBond, ReferenceValues) {  // D 7
    const double ratio = 0.5, radius = sphereBondRadius(ratio, 1e-6, 1e-6);
    EXPECT_DOUBLE_EQ(radius, 5e-7);
    EXPECT_NEAR(sphereBondRadius(ratio, 1, 3) / (2 * ratio * 0.75), 1, 1e-15);  // a_b = 2 a* R*
    EXPECT_NEAR(normalCorrection(ratio, 0.25) / 1.43284, 1, 1e-4);
    const auto k = paperBond(200e9, 0.25, ratio, radius);
    EXPECT_NEAR(k.normal / 1.5284e5, 1, 1e-4);
    EXPECT_NEAR(k.shear / 1.3100e5, 1, 1e-4);
    EXPECT_NEAR(k.bending / 9.5523e-9, 1, 1e-4);
    EXPECT_NEAR(k.torsion / 1.6375e-8, 1, 1e-4);
}

TEST(PaperBond, NormalCorrectionTable) {  // physics A.3, nu = 0.25
    const double table[][2] = {{.1, 1.054}, {.3, 1.201}, {.5, 1.433}, {.6, 1.610},
                               {.7, 1.869}, {.8, 2.302}, {.9, 3.274}, {.95, 4.643}};
    for (const auto& [ratio, value] : table)
        EXPECT_NEAR(normalCorrection(ratio, 0.25), value, 5.1e-4) << ratio;
}

TEST(PaperBond, BecomesABarAsTheNeckFillsTheSphere) {  // D 8
    const double E = 70e9, R = 0.01;
    double previous = 1;
    for (const double gap : {1e-3, 1e-5, 1e-7}) {
        const double ratio = 1 - gap, radius = ratio * R;
        const double L = 2 * R * std::sqrt(1 - ratio * ratio), area = kPi * radius * radius;
        const double off = std::abs(paperBond(E, 0.25, ratio, radius).normal * L / (E * area) - 1);
        EXPECT_LT(off, 3 * gap);
        EXPECT_LT(off, previous);
        previous = off;
    }
}

TEST(PaperBond, ForcesAreThePrintedOnesAndMomentsHaveRepairedExponents) {
    const double E = 3e9, nu = 0.2, ratio = 0.6, R = 0.02, radius = sphereBondRadius(ratio, 2 * R, 2 * R);
    const auto k = paperBond(E, nu, ratio, radius);
    const double f = normalCorrection(ratio, nu), cubes = R * R * R * ratio * ratio * ratio;
    EXPECT_NEAR(k.normal / (E / (1 - nu * nu) * f * radius), 1, 1e-13);             // (5')
    EXPECT_NEAR(k.shear / (2 * E / ((2 - nu) * (1 + nu)) * f * radius), 1, 1e-13);  // (6') with f_T = f_N
    EXPECT_NEAR(k.torsion / (8 * E * cubes * f / ((2 - nu) * (1 + nu))), 1, 1e-13);
    EXPECT_NEAR(k.bending / (2 * E * cubes * f / (1 - nu * nu)), 1, 1e-13);
}

TEST(PaperBond, ChecksItsInput) {
    EXPECT_THROW(normalCorrection(1.0, 0.25), std::invalid_argument);
    EXPECT_THROW(normalCorrection(0.0, 0.25), std::invalid_argument);
    EXPECT_THROW(normalCorrection(0.5, 0.5), std::invalid_argument);
    EXPECT_THROW(paperShearRatio(0.5), std::invalid_argument);
    EXPECT_THROW(paperBond(0, 0.25, 0.5, 0.01), std::invalid_argument);
    EXPECT_THROW(griffithStrength(1e9, 0.25, 30, 0), std::invalid_argument);
}

TEST(PaperForms, InteractionStiffensTheNormalUntilItsRangeEnds) {  // (7) with psi
    EXPECT_EQ(paper::normalCorrection(0.5, 0.25, 0), normalCorrection(0.5, 0.25));
    EXPECT_GT(paper::normalCorrection(0.5, 0.25, 0.2), normalCorrection(0.5, 0.25));
    EXPECT_THROW(paper::normalCorrection(0.9, 0.25, 1.0), std::invalid_argument);
    EXPECT_THROW(paper::normalCorrection(0.5, 0.25, -0.1), std::invalid_argument);
}

TEST(FaceBond, TwoReadingsOfTheRadiusRatio) {
    EXPECT_DOUBLE_EQ(paper::faceRatioClamped(0.2, 1.0), 0.4);
    EXPECT_DOUBLE_EQ(paper::faceRatioClamped(1.0, 1.0), 0.9);
    EXPECT_DOUBLE_EQ(faceRatioNeck(0.3, 0.8), 0.6);
    EXPECT_LT(faceRatioNeck(100.0, 0.1), 1.0);
    // The neck reading is two spheres of radius R cut at distance L: sqrt(1 - a*^2) = L/(2 R).
    const double R = std::sqrt(0.3 * 0.3 + 0.4 * 0.4);
    EXPECT_NEAR(std::sqrt(1 - std::pow(faceRatioNeck(0.3, 0.8), 2)), 0.8 / (2 * R), 1e-15);
}

TEST(BeamBond, IsARoundBeamOfTheFacesArea) {  // (E1)
    const double E = 4e6, area = 3e-4, L = 0.02, a = 0.3, radius = faceBondRadius(area);
    const auto k = beamBond(E, area, L, a);
    EXPECT_NEAR(k.normal / (E * area / L), 1, 1e-14);
    EXPECT_NEAR(k.shear / (a * k.normal), 1, 1e-14);
    EXPECT_NEAR(k.bending / (E * kPi * std::pow(radius, 4) / 4 / L), 1, 1e-14);
    EXPECT_NEAR(k.torsion / (2 * a * k.bending), 1, 1e-14);
    EXPECT_NEAR(k.bending / (k.normal * radius * radius / 4), 1, 1e-14);  // the identities of (9'), (10')
    EXPECT_NEAR(k.torsion / (k.shear * radius * radius / 2), 1, 1e-14);
    // As a kernel makes it from k_N, on the device and in its precision.
    const auto seen = laws::roundBond(float(k.normal), float(a), float(radius));
    EXPECT_NEAR(seen.shear / k.shear, 1, 1e-6);
    EXPECT_NEAR(seen.bending / k.bending, 1, 1e-6);
    EXPECT_NEAR(seen.torsion / k.torsion, 1, 1e-6);
    EXPECT_THROW(beamBond(E, 0, L), std::invalid_argument);
    EXPECT_THROW(beamBond(E, area, L, 1.5), std::invalid_argument);
}

TEST(BondStiffness, ChangeOfUnitsChangesEachConstantByItsDimension) {
    const double metre = 3, force = 11, pressure = force / (metre * metre);
    const auto expectScaled = [&](const BondStiffness<double>& k, const BondStiffness<double>& scaled) {
        EXPECT_NEAR(scaled.normal / k.normal, force / metre, 1e-12);
        EXPECT_NEAR(scaled.shear / k.shear, force / metre, 1e-12);
        EXPECT_NEAR(scaled.bending / k.bending, force * metre, 1e-12);
        EXPECT_NEAR(scaled.torsion / k.torsion, force * metre, 1e-12);
    };
    expectScaled(paperBond(1e9, 0.25, 0.5, 0.1), paperBond(1e9 * pressure, 0.25, 0.5, 0.1 * metre));
    expectScaled(beamBond(1e9, 0.1, 0.2), beamBond(1e9 * pressure, 0.1 * metre * metre, 0.2 * metre));
    EXPECT_NEAR(griffithStrength(1e9 * pressure, 0.25, 30 * force / metre, 0.1 * metre) /
                    griffithStrength(1e9, 0.25, 30, 0.1),
                pressure, 1e-12);
}

}  // namespace
}  // namespace demolish
