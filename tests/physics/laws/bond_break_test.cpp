// SPDX-License-Identifier: Apache-2.0
// When a bond breaks and what happens then: physics D 9, 10, 21, 24.
#include <gtest/gtest.h>

#include "sim_cuda/physics/bond_stiffness.h"
#include "tests/physics/laws/bonded_set.h"

namespace demolish {
namespace {

/// The reference bond of D 7 and D 9.
struct ReferenceBond {
    double E = 200e9, nu = 0.25, gamma = 30, ratio = 0.5, radius = 5e-7, rest = 2e-6;
    double area = kPi * radius * radius;
    BondStiffness<double> k = paperBond(E, nu, ratio, radius);
    double strength = griffithStrength(E, nu, gamma, radius);

    BondDeformation<double> deformed(const Vec3<double>& shift, const Quat<double>& rotation = {}) const {
        const Vec3<double> x{rest, 0, 0};
        return laws::bondDeformation(x, test::atRest(x + shift, Quat<double>{}, rotation));
    }
    bool breaks(const BondDeformation<double>& d) const {
        return laws::bondBreaks(laws::bondSeverity(laws::bondLoad(k, d), radius),
                                laws::severityLimit(strength, radius));
    }
    /// As the solver holds it.
    BondConstants<double> constants() const { return {{rest, 0, 0}, k, radius, strength, 0}; }
};

TEST(BondBreak, TensionAtTheGriffithStrength) {  // D 9
    const ReferenceBond bond;
    EXPECT_NEAR(bond.strength / 2.01851e9, 1, 1e-5);
    const double force = bond.strength * bond.area, stretch = force / bond.k.normal;
    EXPECT_NEAR(force / 1.58533e-3, 1, 1e-5);
    EXPECT_FALSE(bond.breaks(bond.deformed({0.999 * stretch, 0, 0})));
    EXPECT_TRUE(bond.breaks(bond.deformed({1.001 * stretch, 0, 0})));
    const double energy = laws::bondEnergy(bond.k, bond.deformed({stretch, 0, 0}));
    EXPECT_NEAR(energy / (bond.gamma * bond.area), 0.34896, 1e-5);
    EXPECT_NEAR(energy / (bond.gamma * bond.area / (2 * normalCorrection(0.5, 0.25))), 1, 1e-12);
}

TEST(BondBreak, SeverityIsTheStressOfARoundBeam) {  // (11') (12')
    const double a = 0.3, area = kPi * a * a, bending_modulus = kPi * a * a * a / 4, over = kPi * a * a * a;
    const BondLoad<double> load{-7, {3, 0, 4}, -2, {0, 5, 12}};
    const double tension = -7 / area + 13 / bending_modulus, shear = 5 / area + 2 / (2 * bending_modulus);
    EXPECT_NEAR(laws::tensileSeverity(load, a) / over / tension, 1, 1e-14);
    EXPECT_NEAR(laws::shearSeverity(load, a) / over / shear, 1, 1e-14);
    EXPECT_EQ(laws::bondSeverity(load, a), laws::tensileSeverity(load, a)) << "bent most";
    const BondLoad<double> twisted{-7, {3, 0, 4}, -60, {0, 5, 12}};
    EXPECT_EQ(laws::bondSeverity(twisted, a), laws::shearSeverity(twisted, a));
    EXPECT_NEAR(laws::severityLimit(6e4, a) / over, 6e4, 1e-9);
    EXPECT_TRUE(laws::bondBreaks(2.0, 2.0));
    EXPECT_FALSE(laws::bondBreaks(1.999, 2.0));
}

TEST(BondBreak, CompressionAloneNeverBreaks) {
    const ReferenceBond bond;
    EXPECT_FALSE(bond.breaks(bond.deformed({-0.5 * bond.rest, 0, 0})));
}

TEST(BondBreak, PureBendingTorsionAndShear) {  // D 10
    const ReferenceBond bond;
    const double modulus = kPi * std::pow(bond.radius, 3);
    const double shear = bond.strength * bond.area / bond.k.shear;
    const double twist = bond.strength * modulus / 2 / bond.k.torsion;
    const double bend = bond.strength * modulus / 4 / bond.k.bending;
    for (const double share : {0.999, 1.001}) {
        const bool expected = share > 1;
        BondDeformation<double> d = bond.deformed({});
        d.shear = {0, share * shear, 0};
        EXPECT_EQ(bond.breaks(d), expected);
        d = bond.deformed({});
        d.twist = -share * twist;
        EXPECT_EQ(bond.breaks(d), expected);
        d = bond.deformed({});
        d.bending = {0, 0, share * bend};
        EXPECT_EQ(bond.breaks(d), expected);
    }
}

TEST(BondBreak, TwistOfARealParticleBreaksWithinATenthOfAPercent) {  // D 10 through the kinematics
    ReferenceBond bond;
    bond.strength /= 10;  // a brittle strain, as in a body
    const double twist = bond.strength * kPi * std::pow(bond.radius, 3) / 2 / bond.k.torsion;
    const Vec3<double> x{1, 0, 0};
    EXPECT_FALSE(bond.breaks(bond.deformed({}, test::turn(x, 0.999 * twist))));
    EXPECT_TRUE(bond.breaks(bond.deformed({}, test::turn(x, 1.001 * twist))));
}

/// Two particles, bonded until the criterion says no, then in type-3 contact.
struct BreakingPair {
    ReferenceBond bond;
    double mass = 1.6e-14, inertia = 6.5e-27, dt = 2e-11;
    test::ParticleState<double> i, j;
    PairState state = PairState::kBonded;
    double normal_before = 0, normal_after = 0, energy_at_break = 0, kinetic_at_break = 0;

    double kinetic() const {
        return 0.5 * mass * (length2(i.velocity) + length2(j.velocity)) +
               0.5 * inertia * (length2(i.spin) + length2(j.spin));
    }
    void kick(test::ParticleState<double>& s, const Wrench<double>& w) const {
        s.velocity = axpy(dt / mass, w.force, s.velocity);
        s.spin = axpy(dt / inertia, w.torque, s.spin);
        s.position = axpy(dt, s.velocity, s.position);
        s.rotation = advanced(s.rotation, s.spin, dt);
    }
    void step() {
        const BondConstants<double> constants = bond.constants();
        const PairMotion<double> pair = test::pairOf(i, j);
        const Vec3<double> gap = pair.separation;
        const auto d = laws::bondDeformation(constants.rest, pair);
        const auto effect = laws::bondEffect(constants, pair);
        const double overlap = laws::brokenOverlap(bond.rest, length(gap));
        const PairState next =
            laws::nextState(state, laws::bondBreaks(effect.severity, effect.limit), length(gap), bond.rest);
        if (state == PairState::kBonded && next == PairState::kBroken) {
            normal_before = -laws::bondLoad(bond.k, d).normal_force;
            normal_after = laws::brokenRepulsion(bond.k.normal, overlap);
            energy_at_break = laws::bondEnergy(bond.k, d);
            kinetic_at_break = kinetic();
        }
        state = next;
        Wrench<double> on_i, on_j;
        if (state == PairState::kBonded) {
            on_i = {effect.force, effect.torque_i};
            on_j = {-effect.force, -effect.torque_j};
        } else if (state == PairState::kBroken) {
            on_i.force = -laws::brokenRepulsion(bond.k.normal, overlap) * normalized(gap);
            on_j.force = -on_i.force;
        }
        kick(i, on_i);
        kick(j, on_j);
    }
};

TEST(BondBreak, CompressedAndShearedBondReleasesNoMoreThanItStored) {  // D 21
    BreakingPair pair;
    pair.bond.strength /= 20;
    pair.j.position = {pair.bond.rest, 0, 0};
    pair.i.velocity = {1.0, -3.0, 0};
    pair.j.velocity = {-1.0, 3.0, 0};
    double fastest = 0;
    for (int k = 0; k < 40000; ++k) {
        pair.step();
        if (pair.state != PairState::kBonded) fastest = std::max(fastest, pair.kinetic());
    }
    ASSERT_EQ(pair.state, PairState::kContact);
    ASSERT_GT(pair.normal_before, 0);  // it broke in shear, under compression
    EXPECT_NEAR(pair.normal_after / pair.normal_before, 1, 0.02);
    EXPECT_LE(fastest, pair.kinetic_at_break + pair.energy_at_break);
    EXPECT_GT(fastest, pair.kinetic_at_break);
}

TEST(PairStates, GoOneWayOnly) {
    using enum PairState;
    EXPECT_EQ(laws::nextState(kBonded, false, 2.0, 1.0), kBonded);
    EXPECT_EQ(laws::nextState(kBonded, true, 1.0, 1.0), kBroken);
    EXPECT_EQ(laws::nextState(kBroken, false, 1.08, 1.0), kBroken);
    EXPECT_EQ(laws::nextState(kBroken, false, 1.0801, 1.0), kContact);
    for (const bool breaks : {false, true})
        for (const double distance : {0.5, 1.0, 1.5}) {
            EXPECT_EQ(laws::nextState(kContact, breaks, distance, 1.0), kContact);
            EXPECT_NE(laws::nextState(kBroken, breaks, distance, 1.0), kBonded);
        }
}

TEST(StretchRule, IsTheTensileCriterionInOtherUnits) {  // D 24
    const ReferenceBond bond;
    const double limit = laws::stretchLimit(bond.strength, bond.area, bond.k.normal);
    EXPECT_NEAR(limit / (kPi * bond.radius * bond.strength * (1 - bond.nu * bond.nu) /
                         (bond.E * normalCorrection(bond.ratio, bond.nu))),
                1, 1e-12);
    EXPECT_NEAR(limit / bond.rest / (0.51 * bond.strength / bond.E), 1, 0.01);
    for (const double share : {-50.0, 0.0, 0.999, 1.001, 3.0}) {
        const double distance = bond.rest + share * limit;
        EXPECT_EQ(laws::isDiscrete(distance, bond.rest, limit),
                  bond.breaks(bond.deformed({share * limit, 0, 0})))
            << share;
    }
}

TEST(StretchRule, ForceFadesToNothing) {
    EXPECT_DOUBLE_EQ(laws::discreteShare(1.0, 1.0, 0.1, 1.3), 1.0);
    EXPECT_NEAR(laws::discreteShare(1.2, 1.0, 0.1, 1.3), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(laws::discreteShare(1.4, 1.0, 0.1, 1.3), 0.0);
}

}  // namespace
}  // namespace demolish
