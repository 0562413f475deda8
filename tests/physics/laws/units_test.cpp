// SPDX-License-Identifier: Apache-2.0
// The same physics in metres, kilograms and seconds and in millimetres, grams and milliseconds: every law
// must give the same numbers but for the factor of its dimension. (Contact laws and constants of bonds:
// contact_test, bond_stiffness_test.)
#include <gtest/gtest.h>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/pair_state.h"
#include "sim_cuda/physics/rigid_fit.h"
#include "sim_cuda/physics/softening.h"
#include "sim_cuda/physics/time_step.h"
#include "sim_cuda/physics/tough_cells.h"
#include "tests/physics/frequency_bound.h"
#include "tests/physics/laws/random_pairs.h"

namespace demolish {
namespace {

/// mm, g, ms: numbers of small units in a metre, a kilogram, a second.
constexpr double kMetre = 1000, kKilogram = 1000, kSecond = 1000;
constexpr double kVelocity = kMetre / kSecond, kForce = kKilogram * kVelocity / kSecond,
                 kMoment = kForce * kMetre;
constexpr double kPressure = kForce / (kMetre * kMetre), kStiffness = kForce / kMetre, kEnergy = kMoment;
constexpr double kInertia = kKilogram * kMetre * kMetre, kDensity = kKilogram / (kMetre * kMetre * kMetre);

using V = Vec3<double>;

PairMotion<double> small(const PairMotion<double>& p) {
    return {kMetre * p.separation,    p.rotation_i,           p.rotation_j,          kVelocity * p.velocity_i,
            kVelocity * p.velocity_j, 1 / kSecond * p.spin_i, 1 / kSecond * p.spin_j};
}
BondStiffness<double> small(const BondStiffness<double>& k) {
    return {kStiffness * k.normal, kStiffness * k.shear, kMoment * k.bending, kMoment * k.torsion};
}
void expectScaled(const V& scaled, const V& plain, double factor) {
    EXPECT_LT(length(scaled - factor * plain), 1e-10 * factor * (length(plain) + 1e-12));
}

TEST(Units, ABondsForcesDampingBreakAndEnergy) {
    std::mt19937 random(1);
    for (int n = 0; n < 100; ++n) {
        const auto p = test::drawBondedPair<double>(random);
        const BondConstants<double> bond{kMetre * p.bond.rest, small(p.bond.stiffness),
                                         kMetre * p.bond.radius, kPressure * p.bond.strength,
                                         kSecond * p.bond.beta_r};
        const auto a = laws::bondEffect(p.bond, p.motion), b = laws::bondEffect(bond, small(p.motion));
        expectScaled(b.force, a.force, kForce);
        expectScaled(b.torque_i, a.torque_i, kMoment);
        expectScaled(b.torque_j, a.torque_j, kMoment);
        expectScaled(laws::bondDamping(bond, small(p.motion)).force,
                     laws::bondDamping(p.bond, p.motion).force, kForce);
        EXPECT_NEAR(b.severity / b.limit, a.severity / a.limit, 1e-10 * (1 + a.severity / a.limit));
        const auto c = laws::bondRelease(p.bond, p.motion), e = laws::bondRelease(bond, small(p.motion));
        EXPECT_NEAR(e.energy / (kEnergy * c.energy), 1, 1e-9);
        expectScaled(e.load.force, c.load.force, kForce);
        expectScaled(e.load.torque, c.load.torque, kMoment);
    }
}

TEST(Units, SeverityLimitAndEnergyOfABond) {
    const BondStiffness<double> k = beamBond(4e6, 1e-3, 0.05);
    BondDeformation<double> d, e;
    d.normal = e.normal = {1, 0, 0};
    d.stretch = 2e-5;
    d.shear = {0, 1e-5, 0};
    d.twist = e.twist = 1e-3;
    d.bending = e.bending = {0, 0, 2e-3};
    e.stretch = kMetre * d.stretch;
    e.shear = kMetre * d.shear;
    const auto a = laws::bondLoad(k, d), b = laws::bondLoad(small(k), e);
    EXPECT_NEAR(laws::tensileSeverity(b, 0.0178 * kMetre) / (kMoment * laws::tensileSeverity(a, 0.0178)), 1,
                1e-12);
    EXPECT_NEAR(laws::shearSeverity(b, 0.0178 * kMetre) / (kMoment * laws::shearSeverity(a, 0.0178)), 1,
                1e-12);
    EXPECT_NEAR(
        laws::severityLimit(kPressure * 6e4, 0.0178 * kMetre) / (kMoment * laws::severityLimit(6e4, 0.0178)),
        1, 1e-12);
    EXPECT_NEAR(laws::bondEnergy(small(k), e) / (kEnergy * laws::bondEnergy(k, d)), 1, 1e-12);
    const double limit = laws::stretchLimit(3e5, 1e-3, k.normal);
    EXPECT_NEAR(
        laws::stretchLimit(kPressure * 3e5, kMetre * kMetre * 1e-3, kStiffness * k.normal) / (kMetre * limit),
        1, 1e-12);
    for (const double share : {0.9, 1.1})
        EXPECT_EQ(laws::isDiscrete(kMetre * (0.05 + share * limit), kMetre * 0.05, kMetre * limit),
                  share > 1);
    EXPECT_EQ(laws::nextState(PairState::kBroken, false, 1.0801 * kMetre, kMetre), PairState::kContact);
}

TEST(Units, ContactsWithFrictionRollingAndAdhesion) {
    std::mt19937 random(2);
    for (int n = 0; n < 100; ++n) {
        const auto p = test::drawTouchingPair<double>(random);
        const TouchGeometry<double> at{p.geometry.normal, kMetre * p.geometry.overlap,
                                       kMetre * p.geometry.arm_i, kMetre * p.geometry.arm_j};
        const double damping = kForce / kVelocity;
        const TouchLaw<double> law{kStiffness * p.law.stiffness,
                                   kForce * p.law.elastic,
                                   damping * p.law.normal_damping,
                                   kStiffness * p.law.shear,
                                   damping * p.law.shear_damping,
                                   kForce * p.law.adhesion,
                                   p.law.friction,
                                   p.law.rolling,
                                   kMetre * p.law.radius,
                                   kInertia * p.law.inertia};
        const auto a = laws::touchEffect(p.geometry, p.law, p.motion, p.spring, 1e-4);
        const auto b = laws::touchEffect(at, law, small(p.motion), kMetre * p.spring, 1e-4 * kSecond);
        expectScaled(b.load.force, a.load.force, kForce);
        expectScaled(b.load.torque, a.load.torque, kMoment);
        expectScaled(b.spring, a.spring, kMetre);
        EXPECT_NEAR(b.spring_energy / (kEnergy * a.spring_energy), 1, 1e-9);
    }
}

TEST(Units, ContactLawsOfThePairTable) {
    for (const uint32_t hertz : {0u, 1u}) {
        StepParams<double> params, small_params;
        params.hertz = small_params.hertz = hertz;
        params.stiffness_cap = 1e6;
        small_params.stiffness_cap = 1e6 / (kSecond * kSecond);
        const PairLaw<double> pair{1e5, 0.7, 0.4, 0.3, 0.2, 2e7, 8e6};
        const PairLaw<double> small_pair{kStiffness * 1e5, 0.7, 0.4, 0.3, kStiffness * 0.2, kPressure * 2e7,
                                         kPressure * 8e6};
        const auto a = laws::contactTouchLaw(pair, params, 1e-4, 0.02, PairInertia<double>{3.0, 700.0});
        const auto b = laws::contactTouchLaw(small_pair, small_params, 1e-4 * kMetre, 0.02 * kMetre,
                                             PairInertia<double>{3.0 / kKilogram, 700.0 / kInertia});
        EXPECT_NEAR(b.elastic / (kForce * a.elastic), 1, 1e-12);
        EXPECT_NEAR(b.normal_damping / (kForce / kVelocity * a.normal_damping), 1, 1e-12);
        EXPECT_NEAR(b.shear / (kStiffness * a.shear), 1, 1e-12);
        EXPECT_NEAR(b.adhesion / (kForce * a.adhesion), 1, 1e-12);
        EXPECT_NEAR(b.inertia / (kInertia * a.inertia), 1, 1e-12);
    }
}

TEST(Units, BrokenBonds) {
    const V moment{3, 4, 0};
    expectScaled(laws::cappedBendingMoment(kMoment * moment, 0.25, kForce * 8.0, kMetre * 0.5),
                 laws::cappedBendingMoment(moment, 0.25, 8.0, 0.5), kMoment);
    EXPECT_NEAR(laws::brokenRepulsion(kStiffness * 7.0, laws::brokenOverlap(kMetre * 2.0, kMetre * 1.5)) /
                    (kForce * laws::brokenRepulsion(7.0, laws::brokenOverlap(2.0, 1.5))),
                1, 1e-12);
    EXPECT_NEAR(laws::frictionLimit(0.3, kForce * 2.0) / (kForce * laws::frictionLimit(0.3, 2.0)), 1, 1e-12);
    EXPECT_NEAR(laws::fractureEnergy(kEnergy * 5.0, kStiffness * 2.0, kMetre * 1.0) /
                    (kEnergy * laws::fractureEnergy(5.0, 2.0, 1.0)),
                1, 1e-12);
}

TEST(Units, ABondsKinematicsOneByOne) {
    std::mt19937 random(3);
    for (int n = 0; n < 50; ++n) {
        const auto p = test::drawBondedPair<double>(random);
        const PairMotion<double> m = p.motion, scaled = small(p.motion);
        const auto d = laws::bondDeformation(p.bond.rest, m);
        const auto e = laws::bondDeformation(kMetre * p.bond.rest, scaled);
        EXPECT_NEAR(e.stretch / (kMetre * d.stretch), 1, 1e-9);
        EXPECT_NEAR(e.twist, d.twist, 1e-12);
        expectScaled(e.shear, d.shear, kMetre);
        expectScaled(e.arm_i, d.arm_i, kMetre);
        const auto a = laws::bondRates(d, m);
        const auto b = laws::bondRates(e, scaled);
        expectScaled(b.velocity, a.velocity, kVelocity);
        expectScaled(b.spin, a.spin, 1 / kSecond);
    }
}

TEST(Units, ModuliOfAContactAndFadingForce) {
    const auto pair = laws::contactModuli(7e9, 0.2, 3e10, 0.31);
    const auto small_pair = laws::contactModuli(kPressure * 7e9, 0.2, kPressure * 3e10, 0.31);
    EXPECT_NEAR(small_pair.normal / (kPressure * pair.normal), 1, 1e-12);
    EXPECT_NEAR(small_pair.tangential / (kPressure * pair.tangential), 1, 1e-12);
    EXPECT_NEAR(laws::rigidWallModuli(kPressure * 7e9, 0.2).normal /
                    (kPressure * laws::rigidWallModuli(7e9, 0.2).normal),
                1, 1e-12);
    EXPECT_NEAR(laws::discreteShare(kMetre * 1.2, kMetre, kMetre * 0.1, kMetre * 1.3),
                laws::discreteShare(1.2, 1.0, 0.1, 1.3), 1e-12);
}

TEST(Units, WhatContactsLoseWhenTheyBeginEndAndSoften) {
    const double before = laws::overlapBefore(2e-4, -3.0, 1e-4);
    EXPECT_NEAR(laws::overlapBefore(kMetre * 2e-4, -kVelocity * 3.0, kSecond * 1e-4) / (kMetre * before), 1,
                1e-12);
    const auto begun = laws::overlapChange(2e-4, before),
               begun_small = laws::overlapChange(kMetre * 2e-4, kMetre * before);
    EXPECT_GT(laws::crossingLoss(5e4, begun), 0);
    EXPECT_EQ(begun.held, 0);
    EXPECT_NEAR(
        laws::crossingLoss(kStiffness * 5e4, begun_small) / (kEnergy * laws::crossingLoss(5e4, begun)), 1,
        1e-12);
    TouchLaw<double> law, small_law;
    law.softens = small_law.softens = true;
    law.stiffness = 4e4;
    law.shear = 3e4;
    small_law.stiffness = kStiffness * law.stiffness;
    small_law.shear = kStiffness * law.shear;
    const V spring{1e-5, 0, 2e-5};
    const auto held = laws::overlapChange(2e-4, 1e-4),
               held_small = laws::overlapChange(kMetre * 2e-4, kMetre * 1e-4);
    EXPECT_EQ(held.crossed, 0);
    const double loss = laws::softeningLoss(law, 5e4, held, spring);
    EXPECT_GT(loss, 0);
    EXPECT_NEAR(
        laws::softeningLoss(small_law, kStiffness * 5e4, held_small, kMetre * spring) / (kEnergy * loss), 1,
        1e-12);
}

TEST(Units, SpeedsAtWhichBondsWakeAndComeToRest) {
    const auto plain = wakeLaw(0.4, 5, 0.7, 1200), scaled = wakeLaw(0.4, kVelocity * 5, 0.7, 1200);
    EXPECT_NEAR(laws::wakeSpeed(scaled, scaled, 40.0, 300.0) /
                    (kVelocity * laws::wakeSpeed(plain, plain, 40.0, 300.0)),
                1, 1e-12);
    EXPECT_NEAR(calmSpeed(0.4, kVelocity * 5) / (kVelocity * calmSpeed(0.4, 5)), 1, 1e-12);
}

/// A push, then the velocity of a point of the body.
struct PushedPoint {
    DEM_FN V operator()(RigidBody body, V force, V torque, V gravity, double dt, V arm) const {
        advance(body, dt * force, dt * torque, dt * gravity, dt);
        return velocityAt(body.velocity, body.spin, arm);
    }
};

TEST(Units, ARigidBodysStep) {
    RigidBody body, scaled;
    body.inverse_mass = 0.5;
    body.inverse_inertia = {1, 1.0 / 2, 1.0 / 3, 0.05, 0, 0.02};
    body.angular = {1, 6, 0.1};
    body.velocity = {1, 2, 3};
    scaled.inverse_mass = body.inverse_mass / kKilogram;
    const Sym3& j = body.inverse_inertia;
    scaled.inverse_inertia = {j.xx / kInertia, j.yy / kInertia, j.zz / kInertia,
                              j.xy / kInertia, j.yz / kInertia, j.zx / kInertia};
    scaled.angular = kInertia / kSecond * body.angular;
    scaled.velocity = kVelocity * body.velocity;
    const V force{4, 1, 0}, torque{0, 2, 1}, gravity{0, -9.81, 0}, arm{0.1, 0.2, 0};
    expectScaled(laws::evaluate(PushedPoint{}, scaled, kForce * force, kMoment * torque,
                                kVelocity / kSecond * gravity, kSecond * 0.01, kMetre * arm),
                 laws::evaluate(PushedPoint{}, body, force, torque, gravity, 0.01, arm), kVelocity);
}

TEST(Units, StableStepAndSoftening) {
    const auto k = beamBond(4e6, 1.1e-3, 0.05);
    const test::BondEnd i{0.2, 3e-5, 7, 0.02}, j{0.9, 2e-4, 11, 0.03};
    const auto small_end = [](const test::BondEnd& e) {
        return test::BondEnd{kKilogram * e.mass, kInertia * e.inertia, e.bonds, kMetre * e.arm};
    };
    const double omega2 = test::frequencyBoundSquared(k, i, j);
    EXPECT_NEAR(
        test::frequencyBoundSquared(small(k), small_end(i), small_end(j)) * kSecond * kSecond / omega2, 1,
        1e-12);
    const double omega = std::sqrt(omega2);
    EXPECT_NEAR(stableStep(omega / kSecond, 0.3) / (kSecond * stableStep(omega, 0.3)), 1, 1e-12);
    EXPECT_NEAR(stiffnessDamping(0.3, omega / kSecond) / (kSecond * stiffnessDamping(0.3, omega)), 1, 1e-12);
    const double modulus = bondModulusForStep(1e7, omega, 0.5, 5e-5);
    EXPECT_NEAR(
        bondModulusForStep(kPressure * 1e7, omega / kSecond, 0.5, 5e-5 * kSecond) / (kPressure * modulus), 1,
        1e-12);
    const double effective = effectiveModulus(modulus, 0.3), speed = waveSpeed(effective, 2400);
    EXPECT_NEAR(waveSpeed(kPressure * effective, kDensity * 2400) / (kVelocity * speed), 1, 1e-12);
    EXPECT_NEAR(criticalStep(omega / kSecond) / (kSecond * criticalStep(omega)), 1, 1e-12);
    EXPECT_NEAR(effectiveModulusPaper(kPressure * modulus) / (kPressure * effectiveModulusPaper(modulus)), 1,
                1e-12);
    EXPECT_NEAR(cellsThroughWall(kMetre * kMetre * kMetre * 0.02, kMetre * kMetre * 0.5, kMetre * 0.01),
                cellsThroughWall(0.02, 0.5, 0.01), 1e-12);
    const double strength = bondStrength(0.4, 2400, speed, 5);
    EXPECT_NEAR(bondStrength(0.4, kDensity * 2400, kVelocity * speed, kVelocity * 5) / (kPressure * strength),
                1, 1e-12);
    EXPECT_NEAR(
        strainAtFailure(kPressure * strength, kPressure * effective) / strainAtFailure(strength, effective),
        1, 1e-12);
}

TEST(Units, MotionOfAFragment) {
    std::mt19937 random(5);
    const auto fit = [&](double metre, double kilogram, double second) {
        random.seed(5);
        std::vector<V> x, v, w;
        MassSums sums;
        SpinSums spins;
        for (int n = 0; n < 40; ++n) {
            x.push_back(metre * test::drawVector<double>(random, 1));
            v.push_back(metre / second * test::drawVector<double>(random, 3));
            w.push_back(1 / second * test::drawVector<double>(random, 5));
            sums = sums + laws::massOf(kilogram * (1 + n), x[n], v[n]);
        }
        for (int n = 0; n < 40; ++n)
            spins =
                spins + laws::spinOf(kilogram * (1 + n), 0.01 * kilogram * metre * metre,
                                     x[n] - laws::massCentre(sums), v[n] - laws::meanVelocity(sums), w[n]);
        return laws::rigidMotion(sums, spins);
    };
    const RigidMotion a = fit(1, 1, 1), b = fit(kMetre, kKilogram, kSecond);
    expectScaled(b.centre, a.centre, kMetre);
    expectScaled(b.velocity, a.velocity, kVelocity);
    expectScaled(b.spin, a.spin, 1 / kSecond);
}

TEST(Units, ToughCellsKeepTheirShape) {
    std::mt19937 random(6);
    std::vector<V> points, small_points;
    for (int n = 0; n < 600; ++n) {
        points.push_back(test::drawVector<double>(random, 0.3));
        small_points.push_back(kMetre * points.back());
    }
    const double volume = 0.6 * 0.6 * 0.6;
    const auto a = toughCellLabels(points, volume, 20, 3);
    const auto b = toughCellLabels(small_points, kMetre * kMetre * kMetre * volume, 20, 3);
    int moved = 0;
    for (size_t n = 0; n < a.size(); ++n) moved += a[n] != b[n];
    EXPECT_LE(moved, 1);  // the noise is looked up in single precision
}

}  // namespace
}  // namespace demolish
