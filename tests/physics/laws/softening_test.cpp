// SPDX-License-Identifier: Apache-2.0
// Softening, strength, time step: formulas of models E.1-E.2 and physics B.3 against their own tables and
// small exact cases.
#include "sim_cuda/physics/softening.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/time_step.h"
#include "tests/physics/frequency_bound.h"
#include "tests/physics/models/sheet_fits.h"

namespace demolish {
namespace {

TEST(Softening, ModulusMakesTheStepTheWantedShareOfTheCriticalOne) {
    const double trial = 1e6, omega = 4000, dt = 1.0 / 60 / 300, safety = 0.5;
    const double modulus = bondModulusForStep(trial, omega, safety, dt);
    const double softened_omega = omega * std::sqrt(modulus / trial);
    EXPECT_NEAR(dt / criticalStep(softened_omega), safety, 1e-12);
}

TEST(Softening, EffectiveModulusOfTheBeamLaw) {  // (E4) against the measured bars, 3 %
    EXPECT_NEAR(effectiveModulus(1, 0.3), 0.674, 5e-4);
    EXPECT_NEAR(effectiveModulus(1, 0.3) / 0.682, 1, 0.03);
    EXPECT_NEAR(effectiveModulus(1, 0.0) / 0.465, 1, 0.08);
    EXPECT_NEAR(effectiveModulus(1, 1.0) / 0.990, 1, 0.03);
    EXPECT_NEAR(effectiveModulus(3e6 / effectiveModulus(1, 0.3), 0.3), 3e6, 1e-6);  // not softened
}

TEST(Softening, CalibrationMeetsTheMeasuredSpheres) {  // E.2, within the stated scatter
    const double rows[][3] = {{500, .596, .359}, {1000, .662, .369}, {2000, .704, .403}, {4000, .773, .419}};
    for (const auto& [particles, plain, cells] : rows) {
        const double ratio = tests::diameterOverSpacing(particles);
        EXPECT_NEAR(tests::calibratedBeta(ratio) / plain, 1, 0.04) << particles;
        EXPECT_NEAR(tests::calibratedBetaToughCells(ratio) / cells, 1, 0.06) << particles;
    }
    EXPECT_NEAR(tests::diameterOverSpacing(1000), 12.4, 0.05);
}

TEST(Softening, RabbitRowOfTheDesignTable) {  // E.3: N 1500, v_c 2.5, beta 0.4, c 91 m/s
    const double strength = bondStrength(0.4, 2400, 91, 2.5);
    EXPECT_NEAR(strength, 0.22e6, 0.01e6);
    const double modulus = 2400 * 91.0 * 91.0;
    EXPECT_NEAR(waveSpeed(modulus, 2400), 91, 1e-12);
    EXPECT_NEAR(strainAtFailure(strength, modulus), 0.011, 0.0005);
}

TEST(Softening, ThinWallsAloneAreWeakened) {
    EXPECT_NEAR(cellsThroughWall(0.02 * 3, 2 * 3, 0.02), 1, 1e-12) << "a plate, its edge left out";
    EXPECT_NEAR(cellsThroughWall(4.0 / 3 * kPi, 4 * kPi, 0.1), 20.0 / 3, 1e-12) << "a third of the diameter";
    EXPECT_EQ(thinWallShare(1.2), 1);
    EXPECT_EQ(thinWallShare(40), 1);
    EXPECT_NEAR(thinWallShare(1.2 - 1e-9), 1, 1e-8) << "no step";
    EXPECT_EQ(thinWallShare(0.1), thinWallShare(0.6)) << "not measured below";
    // Speeds at which dropped bodies broke without it, by cells through the wall: with it each lies near the
    // mean.
    const std::vector<std::pair<double, double>> plates{
        {0.72, 0.891}, {0.94, 0.863}, {1.25, 0.756}, {1.5, 0.774}, {1.9, 0.770}},
        tubes{{0.59, 0.925}, {0.75, 0.830}, {0.99, 0.734}, {1.25, 0.773}, {1.5, 0.702}, {1.9, 0.678}},
        vase{{0.76, 0.259}, {1.10, 0.190}, {1.64, 0.164}};
    for (const auto& [body, bound] : {std::pair(plates, 0.17), {tubes, 0.19}, {vase, 0.07}}) {
        double mean = 0;
        for (const auto& [cells, speed] : body)
            mean += speed * thinWallShare(cells) / static_cast<double>(body.size());
        for (const auto& [cells, speed] : body)
            EXPECT_NEAR(speed * thinWallShare(cells) / mean, 1, bound) << cells;
    }
}

TEST(TimeStep, BoundIsExactForOneSymmetricBondAndNeverBelow) {  // B.3
    const double m = 1.3, inertia = 9e-4, arm = 0.042;
    const auto k = paperBond(5e7, 0.25, 0.5, 0.021);
    const test::BondEnd end{m, inertia, 1, arm};
    const double bound = test::frequencyBoundSquared(k, end, end);
    // Free pair: stretch 2k_N/m; twist 2k_P/I; bending 2k_B/I; shear with both rotations 2k_T(1/m + arm^2/I).
    const double shear = 2 * k.shear * (1 / m + arm * arm / inertia);
    const double largest =
        std::max({2 * k.normal / m, 2 * k.torsion / inertia, 2 * k.bending / inertia, shear});
    EXPECT_NEAR(bound / largest, 1, 1e-12);
    const test::BondEnd heavier{3 * m, 5 * inertia, 1, 0.7 * arm};
    EXPECT_LT(test::frequencyBoundSquared(k, end, heavier), bound);
    const test::BondEnd crowded{m, inertia, 7, arm};
    EXPECT_NEAR(test::frequencyBoundSquared(k, crowded, crowded) / bound, 7, 1e-9);
}

TEST(TimeStep, DampedLeapfrogIsStableJustBelowItsLimitAndNotAbove) {  // B.3, lagged damping
    const double omega = 100;
    for (const double zeta : {0.1, 0.3, 0.6}) {
        for (const double share : {0.99, 1.01}) {
            const double dt = share * dampedStepShare(zeta) * criticalStep(omega),
                         beta = stiffnessDamping(zeta, omega);
            double x = 1, v = 0, largest = 0;
            for (int step = 0; step < 20000; ++step) {
                v -= dt * omega * omega * (x + beta * v);
                x += dt * v;
                largest = std::max(largest, std::abs(x));
                if (largest > 1e6) break;
            }
            EXPECT_EQ(largest > 1e6, share > 1) << zeta;
        }
        EXPECT_LE(stableStep(omega, zeta), dampedStepShare(zeta) * criticalStep(omega));
    }
    EXPECT_NEAR(dampedStepShare(0.75), 0.5, 1e-12);
}

}  // namespace
}  // namespace demolish
