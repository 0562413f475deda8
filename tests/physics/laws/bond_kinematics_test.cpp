// SPDX-License-Identifier: Apache-2.0
// The bond law on moving pairs: no force for rigid motion, exact opposites, conserved momenta: physics D 15,
// 18, 22.
#include <gtest/gtest.h>

#include <random>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/broken_bond.h"
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

template <class T>
struct RandomPair {
    ParticleState<T> i, j;
    BondRest<T> rest;
};
template <class T>
RandomPair<T> drawPair(std::mt19937& random) {
    RandomPair<T> p;
    p.rest = {normalized(drawVector<T>(random, 1)), T(0.03), T(0.02)};
    p.i = {drawVector<T>(random, 1), drawRotation<T>(random), drawVector<T>(random, 3),
           drawVector<T>(random, 20)};
    p.j = {p.i.position + T(0.051) * rotate(p.i.rotation, p.rest.normal) + drawVector<T>(random, 1e-3),
           advanced(p.i.rotation, drawVector<T>(random, 30), T(1e-3)), drawVector<T>(random, 3),
           drawVector<T>(random, 20)};
    return p;
}
template <class T>
struct Evaluated {
    BondDeformation<T> deformation;
    BondLoad<T> load;
    Wrench<T> wrench;
    BondStress<T> stress;
};
template <class T>
Evaluated<T> evaluate(const RandomPair<T>& p, T beta_r) {
    Evaluated<T> e;
    e.deformation = laws::bondDeformation(p.rest, p.j.position - p.i.position, p.i.rotation, p.j.rotation);
    const auto rates = laws::bondRates(e.deformation, p.i.velocity, p.i.spin, p.j.velocity, p.j.spin);
    const auto elastic = laws::bondLoad(stiffness<T>(), e.deformation);
    e.load = laws::dampedBondLoad(elastic, stiffness<T>(), e.deformation, rates, beta_r);
    e.wrench = laws::bondWrench(e.load, e.deformation);
    e.stress = laws::bondStress(elastic, T(1e-3), T(0.0178));
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
        const RandomPair<T> swapped{
            pair.j, pair.i, {-pair.rest.normal, pair.rest.length_j, pair.rest.length_i}};
        const auto a = evaluate(pair, T(1e-4)), b = evaluate(swapped, T(1e-4));
        expectOpposite(a.wrench.force, b.wrench.force);
        expectOpposite(a.load.shear_force, b.load.shear_force);
        expectOpposite(a.load.bending_moment, b.load.bending_moment);
        ASSERT_EQ(a.load.normal_force, b.load.normal_force);
        ASSERT_EQ(a.load.torsion_moment, b.load.torsion_moment);
        ASSERT_EQ(a.deformation.arm_j.x, b.deformation.arm_i.x);
        ASSERT_EQ(a.stress.tension, b.stress.tension);  // both ends decide alike
        ASSERT_EQ(a.stress.shear, b.stress.shear);
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
        const RandomPair<double> swapped{
            pair.j, pair.i, {-pair.rest.normal, pair.rest.length_j, pair.rest.length_i}};
        const auto a = evaluate(pair, 1e-4), b = evaluate(swapped, 1e-4);
        const auto torque = a.wrench.torque + b.wrench.torque + cross(pair.i.position, a.wrench.force) +
                            cross(pair.j.position, b.wrench.force);
        EXPECT_LT(length(torque), 1e-12 * (length(a.wrench.force) + length(a.wrench.torque)));
    }
}

TEST(BondKinematics, EachChannelSeesItsOwnMotion) {
    const Vec3<double> x{1, 0, 0};
    const BondRest<double> rest{x, 0.5, 0.5};
    const auto stretched =
        laws::bondDeformation(rest, Vec3<double>{1.001, 0, 0}, Quat<double>{}, Quat<double>{});
    EXPECT_NEAR(stretched.stretch, 1e-3, 1e-15);
    EXPECT_NEAR(length(stretched.shear), 0, 1e-15);
    const auto sheared =
        laws::bondDeformation(rest, Vec3<double>{1, 2e-3, 0}, Quat<double>{}, Quat<double>{});
    EXPECT_NEAR(sheared.shear.y, 2e-3, 1e-15);
    const auto twisted = laws::bondDeformation(rest, x, Quat<double>{}, test::turn(x, 0.01));
    EXPECT_NEAR(twisted.twist, 0.01, 1e-7);
    EXPECT_NEAR(length(twisted.bending), 0, 1e-15);
    const auto bent = laws::bondDeformation(rest, x, Quat<double>{}, test::turn(Vec3<double>{0, 0, 1}, 0.15));
    EXPECT_NEAR(bent.bending.z, 0.15, 1e-3 * 0.15);  // the stated accuracy of theta = 2 vec(dq)
    const auto other_cover = laws::bondDeformation(rest, x, Quat<double>{},
                                                   Quat<double>{-std::sin(0.005), 0, 0, -std::cos(0.005)});
    EXPECT_NEAR(other_cover.twist, 0.01, 1e-7);
}

TEST(BondDamping, VanishesForRigidMotionAndTakesEnergyOut) {  // D 18, law level
    const auto k = stiffness<double>();
    const Vec3<double> spin{3, -2, 5}, drift{1, 2, 3}, x{1, 0, 0}, at{0.05, 0, 0};
    const auto d =
        laws::bondDeformation(BondRest<double>{x, 0.025, 0.025}, at, Quat<double>{}, Quat<double>{});
    const auto rigid = laws::bondRates(d, drift, spin, drift + cross(spin, at), spin);
    EXPECT_LT(length(rigid.velocity), 1e-15);
    EXPECT_EQ(length(rigid.spin), 0);
    const auto rates =
        laws::bondRates(d, Vec3<double>{}, Vec3<double>{}, Vec3<double>{0.3, 0.1, 0}, Vec3<double>{1, 0, 2});
    const auto elastic = laws::bondLoad(k, d), damped = laws::dampedBondLoad(elastic, k, d, rates, 1e-4);
    const auto on_i = laws::bondWrench(damped, d), elastic_i = laws::bondWrench(elastic, d);
    const auto moment = on_i.torque - cross(d.arm_i, on_i.force), force = on_i.force - elastic_i.force;
    const double power = dot(force, rates.velocity) + dot(moment, rates.spin);
    EXPECT_GT(power, 0);
    EXPECT_NEAR(laws::bondDampingPower(k, d, rates, 1e-4) / power, 1, 1e-12);
}

TEST(BrokenBond, SpinningInPlaceMakesNoNormalForce) {  // D 22
    const double rest = 0.05, k = 1e6;
    const Vec3<double> x{1, 0, 0};
    const auto turned = test::turn(Vec3<double>{0, 0, 1}, kPi / 2);
    EXPECT_EQ(laws::brokenRepulsion(k, laws::brokenOverlap(rest, length(rest * x))), 0);
    // With both spun in place the body-fixed normal sees an overlap: what the line of centres guards against.
    const auto bonded =
        laws::bondDeformation(BondRest<double>{x, rest / 2, rest / 2}, rest * x, turned, turned);
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
