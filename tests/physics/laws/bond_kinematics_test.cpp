// SPDX-License-Identifier: Apache-2.0
// The bond law on moving pairs: no force for rigid motion, exact opposites, conserved momenta: physics D 15,
// 18, 22.
#include <gtest/gtest.h>

#include <random>

#include "tests/physics/laws/bonded_set.h"
#include "tests/physics/laws/random_pairs.h"

namespace demolish {
namespace {

using test::drawRotation;
using test::drawVector;

template <class T>
BondStiffness<T> stiffness() {
    const auto k = beamBond(4e6, 1e-3, 0.05);
    return {T(k.normal), T(k.shear), T(k.bending), T(k.torsion)};
}

/// J, that a bond takes in while its second end is turned in place, by so many rad about `axis`, over the
/// energy that it has then.
double takenInOverEnergy(const Vec3<double>& axis, double angle) {
    constexpr int kSteps = 20000;
    auto set = test::chain<double>(1, 0.0625, stiffness<double>());
    Quat<double>& turned = set.particles[1].rotation;
    double taken_in = 0;
    for (int k = 0; k < kSteps; ++k) {
        turned = advanced(turned, axis, 0.5 * angle / kSteps);
        set.evaluate();
        taken_in -= dot(set.loads[1].torque, axis) * angle / kSteps;
        turned = advanced(turned, axis, 0.5 * angle / kSteps);
    }
    return taken_in / set.elasticEnergy();
}
/// J: what the springs of a bond hold.
double energyOf(const BondConstants<double>& bond, const PairMotion<double>& pair) {
    return laws::bondEnergy(bond.stiffness, laws::bondDeformation(bond.rest, pair));
}
/// What i gets, as the slope of that energy: central differences along and about the three axes.
Wrench<double> slopeOfEnergy(const BondConstants<double>& bond, const PairMotion<double>& pair) {
    constexpr double kStep = 1e-6;
    const auto slope = [&](const Vec3<double>& axis, const auto& moved) {
        return (energyOf(bond, moved(kStep * axis)) - energyOf(bond, moved(-kStep * axis))) / (2 * kStep);
    };
    const auto shifted = [&](const Vec3<double>& way) {
        PairMotion<double> there = pair;
        there.separation = pair.separation - way;
        return there;
    };
    const auto turned = [&](const Vec3<double>& angle) {
        PairMotion<double> there = pair;
        there.rotation_i = advanced(pair.rotation_i, angle, 1.0);
        return there;
    };
    const Vec3<double> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return {-1.0 * Vec3<double>{slope(x, shifted), slope(y, shifted), slope(z, shifted)},
            -1.0 * Vec3<double>{slope(x, turned), slope(y, turned), slope(z, turned)}};
}
/// However far it is bent, twisted, stretched and sheared, all at once.
TEST(BondKinematics, ABondPullsAndTurnsByTheSlopeOfItsEnergy) {
    std::mt19937 random(17);
    const Vec3<double> rest{0.05, 0.01, -0.02};
    const BondConstants<double> bond{rest, stiffness<double>(), 0.0178, 6e4, 0.0};
    for (int k = 0; k < 300; ++k) {
        const auto i = drawRotation<double>(random);
        const auto bent = drawVector<double>(random, 1.0);
        const auto between = test::turn(normalized(bent), 2.5 * length(bent));
        const auto apart = rotate(i, rest) + drawVector<double>(random, 0.02);
        const auto pair = test::atRest(apart, i, multiply(between, i));
        const auto effect = laws::bondEffect(bond, pair);
        const auto slope = slopeOfEnergy(bond, pair);
        EXPECT_LT(length(effect.force - slope.force), 1e-6 * length(effect.force));
        EXPECT_LT(length(effect.torque_i - slope.torque), 1e-6 * length(effect.torque_i));
    }
}
/// J, of two bonded particles of 1 kg that are let go bent by `angle` and askew, before and after 2,000
/// steps.
std::pair<double, double> energiesLetGo(double angle, std::mt19937& random) {
    auto set = test::chain<double>(1, 0.0625, stiffness<double>());
    set.inertia = 6e-4;
    set.particles[1].rotation = test::turn(normalized(drawVector<double>(random, 1.0)), angle);
    set.particles[1].position = set.particles[1].position + drawVector<double>(random, 0.01);
    const double before = set.elasticEnergy();
    for (int k = 0; k < 2000; ++k) set.step(2e-5);
    double after = set.elasticEnergy();
    for (const auto& s : set.particles)
        after += 0.5 * (set.mass * length2(s.velocity) + set.inertia * length2(s.spin));
    return {before, after};
}
/// Bent by half a turn, the ends say no way from one to the other.
TEST(BondKinematics, ABondBentByHalfATurnGivesBackWhatItHolds) {
    std::mt19937 random(23);
    double before = 0, after = 0;
    for (int k = 0; k < 100; ++k) {
        const auto [first, last] = energiesLetGo(kPi - 0.02 * (k % 10), random);
        EXPECT_NEAR(last / first, 1, 0.1) << k;
        before += first;
        after += last;
    }
    EXPECT_NEAR(after / before, 1, 0.01);
}
/// Rubber bends by a radian before it breaks.
TEST(BondKinematics, ABondHoldsWhatItHasTakenInHoweverFarItTurns) {
    for (const double angle : {0.01, 0.3, 1.0, 2.0, -1.5}) {
        EXPECT_NEAR(takenInOverEnergy({1, 0, 0}, angle), 1, 1e-6) << "twisted by " << angle;
        EXPECT_NEAR(takenInOverEnergy({0, 0.6, 0.8}, angle), 1, 1e-6) << "bent by " << angle;
        EXPECT_NEAR(takenInOverEnergy({0.8, 0.6, 0}, angle), 1, 1e-6) << "both by " << angle;
    }
}

/// Largest force on any particle of a rigidly moved lattice, in units of k_N L0.
template <class T>
T largestRigidForce(double reach) {
    const T pitch = T(0.0625);
    std::mt19937 random(7);
    T worst = 0;
    for (int trial = 0; trial < 200; ++trial) {
        auto set = test::chain<T>(3, pitch, stiffness<T>());
        const auto q = drawRotation<T>(random);
        const auto shift = drawVector<T>(random, reach * pitch);
        for (auto& s : set.particles) {
            s.rotation = q;
            s.position = rotate(q, s.position) + shift;
        }
        set.evaluate();
        for (const auto& load : set.loads)
            worst = std::max(worst, length(load.force) / (stiffness<T>().normal * pitch));
    }
    return worst;
}
TEST(BondKinematics, RigidMotionGivesNoForce) {  // D 15
    EXPECT_LT(largestRigidForce<double>(100), 1e-12);
    EXPECT_LT(largestRigidForce<float>(0.5), 1e-6f);
}

/// A pair with the stiffnesses above.
template <class T>
test::BondedPair<T> drawPair(std::mt19937& random) {
    test::BondedPair<T> p = test::drawBondedPair<T>(random);
    p.bond.stiffness = stiffness<T>();
    return p;
}
template <class T>
struct Evaluated {
    BondDeformation<T> deformation;
    BondLoad<T> springs, dampers;
    BondEffect<T> effect;
};
template <class T>
Evaluated<T> evaluate(const test::BondedPair<T>& p) {
    Evaluated<T> e;
    e.deformation = laws::bondDeformation(p.bond.rest, p.motion);
    const auto rates = laws::bondRates(e.deformation, p.motion);
    e.springs = laws::bondLoad(p.bond.stiffness, e.deformation);
    e.dampers = laws::damperLoad(p.bond.stiffness, e.deformation, rates, p.bond.beta_r);
    e.effect = laws::bondEffect(p.bond, p.motion);
    return e;
}
template <class T>
void expectOpposite(const Vec3<T>& a, const Vec3<T>& b) {
    ASSERT_EQ(a.x, -b.x);
    ASSERT_EQ(a.y, -b.y);
    ASSERT_EQ(a.z, -b.z);
}
template <class T>
void expectExactExchange() {
    std::mt19937 random(11);
    for (int k = 0; k < 3000; ++k) {
        const auto pair = drawPair<T>(random);
        const auto a = evaluate(pair), b = evaluate(test::exchanged(pair));
        expectOpposite(a.effect.force, b.effect.force);
        for (const auto load : {&Evaluated<T>::springs, &Evaluated<T>::dampers}) {
            expectOpposite((a.*load).shear_force, (b.*load).shear_force);
            expectOpposite((a.*load).bending_moment, (b.*load).bending_moment);
            ASSERT_EQ((a.*load).normal_force, (b.*load).normal_force);
            ASSERT_EQ((a.*load).torsion_moment, (b.*load).torsion_moment);
        }
        ASSERT_EQ(a.deformation.arm_j.x, b.deformation.arm_i.x);
        ASSERT_EQ(a.effect.severity, b.effect.severity);  // both ends decide alike
    }
}
TEST(BondKinematics, ExchangeOfTheTwoParticlesNegatesEverythingToTheBit) {
    expectExactExchange<float>();
    expectExactExchange<double>();
}

TEST(BondKinematics, ForcesActAtOneCommonPoint) {
    std::mt19937 random(13);
    for (int k = 0; k < 200; ++k) {
        const auto pair = drawPair<double>(random);
        const auto a = evaluate(pair).effect, b = evaluate(test::exchanged(pair)).effect;
        const auto torque = a.torque_i + b.torque_i + cross(pair.motion.separation, b.force);  // about i
        EXPECT_LT(length(torque), 1e-12 * (length(a.force) + length(a.torque_i)));
    }
}

TEST(BondKinematics, EachChannelSeesItsOwnMotion) {
    const Vec3<double> x{1, 0, 0};
    const auto deformed = [&](const Vec3<double>& separation, const Quat<double>& rotation_j) {
        return laws::bondDeformation(x, test::atRest(separation, Quat<double>{}, rotation_j));
    };
    const auto stretched = deformed({1.001, 0, 0}, {});
    EXPECT_NEAR(stretched.stretch, 1e-3, 1e-15);
    EXPECT_NEAR(length(stretched.shear), 0, 1e-15);
    const auto sheared = deformed({1, 2e-3, 0}, {});
    EXPECT_NEAR(sheared.shear.y, 2e-3, 1e-15);
    const auto twisted = deformed(x, test::turn(x, 0.01));
    EXPECT_NEAR(twisted.twist, 0.01, 1e-7);
    EXPECT_NEAR(length(twisted.bending), 0, 1e-15);
    const auto bent = deformed(x, test::turn(Vec3<double>{0, 0, 1}, 0.15));
    EXPECT_NEAR(bent.bending.z, 0.15, 1e-3 * 0.15);  // the stated accuracy of theta = 2 vec(dq)
    const auto other_cover = deformed(x, {-std::sin(0.005), 0, 0, -std::cos(0.005)});
    EXPECT_NEAR(other_cover.twist, 0.01, 1e-7);
}

TEST(BondDamping, VanishesForRigidMotionAndTakesEnergyOut) {  // D 18, law level
    const Vec3<double> spin{3, -2, 5}, drift{1, 2, 3}, at{0.05, 0, 0};
    const BondConstants<double> bond{at, stiffness<double>(), 0.0178, 6e4, 1e-4};
    PairMotion<double> pair = test::atRest(at, Quat<double>{}, Quat<double>{});
    pair.velocity_i = drift;
    pair.velocity_j = drift + cross(spin, at);
    pair.spin_i = pair.spin_j = spin;
    const auto d = laws::bondDeformation(at, pair);
    const auto rigid = laws::bondRates(d, pair);
    EXPECT_LT(length(rigid.velocity), 1e-15);
    EXPECT_EQ(length(rigid.spin), 0);
    pair.velocity_i = pair.spin_i = {};
    pair.velocity_j = {0.3, 0.1, 0};
    pair.spin_j = {1, 0, 2};
    const auto rates = laws::bondRates(d, pair);
    const auto damping = laws::bondDamping(bond, pair);
    const auto moment = damping.torque_i - cross(d.arm_i, damping.force);
    const double power = dot(damping.force, rates.velocity) + dot(moment, rates.spin);
    EXPECT_GT(power, 0);
    // (E3): beta_R times stiffness times rate, channel by channel.
    const double speed = dot(rates.velocity, d.normal), twist = dot(rates.spin, d.normal);
    const auto slip = rates.velocity - speed * d.normal, bend = rates.spin - twist * d.normal;
    const BondStiffness<double>& k = bond.stiffness;
    EXPECT_NEAR(bond.beta_r *
                    (k.normal * speed * speed + k.shear * length2(slip) + k.torsion * twist * twist +
                     k.bending * length2(bend)) /
                    power,
                1, 1e-12);
}

TEST(BrokenBond, SpinningInPlaceMakesNoNormalForce) {  // D 22
    const double rest = 0.05, k = 1e6;
    const Vec3<double> x{rest, 0, 0};
    const auto turned = test::turn(Vec3<double>{0, 0, 1}, kPi / 2);
    EXPECT_EQ(laws::brokenRepulsion(k, laws::brokenOverlap(rest, length(x))), 0);
    // With both spun in place the body-fixed normal sees an overlap: what the line of centres guards against.
    const auto bonded = laws::bondDeformation(x, test::atRest(x, turned, turned));
    EXPECT_LT(bonded.stretch, -0.5 * rest);
}

TEST(BrokenBond, OnlyPushesAndItsMomentIsCapped) {  // (14') (15')
    EXPECT_EQ(laws::brokenRepulsion(1e6, -0.01), 0);
    EXPECT_DOUBLE_EQ(laws::brokenRepulsion(1e6, 0.01), 1e4);
    EXPECT_DOUBLE_EQ(laws::frictionLimit(0.5, 1e4), 5e3);
    EXPECT_NEAR(length(laws::cappedBendingMoment(Vec3<double>{3, 4, 0}, 0.25, 8.0, 0.5)), 1.0, 1e-15);
    EXPECT_EQ(laws::cappedBendingMoment(Vec3<double>{0.3, 0.4, 0}, 0.25, 8.0, 0.5).x, 0.3);
    EXPECT_EQ(length(laws::cappedBendingMoment(Vec3<double>{3, 4, 0}, 0.0, 8.0, 0.5)), 0);
    EXPECT_DOUBLE_EQ(laws::fractureEnergy(5.0, 2.0, 1.0), 4.0);
    EXPECT_DOUBLE_EQ(laws::fractureEnergy(5.0, 2.0, -1.0), 5.0);
}

}  // namespace
}  // namespace demolish
