// SPDX-License-Identifier: Apache-2.0
// Which particle comes first must not matter, to any law: what one gets is the exact opposite of what the
// other gets, and both decide alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/pair_state.h"
#include "sim_cuda/physics/rigid_fit.h"
#include "tests/physics/frequency_bound.h"
#include "tests/physics/laws/random_pairs.h"

namespace demolish {
namespace {

constexpr int kPairs = 2000;

template <class T>
bool opposite(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x == -b.x && a.y == -b.y && a.z == -b.z;
}

template <class T>
void expectBondsOdd() {
    std::mt19937 random(1);
    int broken = 0;
    for (int k = 0; k < kPairs; ++k) {
        const auto p = test::drawBondedPair<T>(random), q = test::exchanged(p);
        const auto a = laws::bondEffect(p.bond, p.motion), b = laws::bondEffect(q.bond, q.motion);
        ASSERT_TRUE(opposite(a.force, b.force));
        ASSERT_TRUE(opposite(a.torque_i, b.torque_j));  // torque_j is the opposite of what j gets
        ASSERT_TRUE(opposite(a.torque_j, b.torque_i));
        ASSERT_EQ(a.severity, b.severity);
        ASSERT_EQ(a.limit, b.limit);
        const auto c = laws::bondDamping(p.bond, p.motion), d = laws::bondDamping(q.bond, q.motion);
        ASSERT_TRUE(opposite(c.force, d.force));
        ASSERT_TRUE(opposite(c.torque_i, d.torque_j));
        const auto e = laws::bondRelease(p.bond, p.motion), f = laws::bondRelease(q.bond, q.motion);
        ASSERT_EQ(e.energy, f.energy);
        ASSERT_TRUE(opposite(e.load.force, f.load.force));
        broken += a.severity >= a.limit;
    }
    EXPECT_GT(broken, kPairs / 10);
    EXPECT_LT(broken, kPairs * 9 / 10);
}

TEST(Exchange, BondsGiveExactOpposites) {
    expectBondsOdd<float>();
    expectBondsOdd<double>();
}

template <class T>
void expectTouchesOdd() {
    std::mt19937 random(2);
    int pulled_off = 0;
    for (int k = 0; k < kPairs; ++k) {
        const auto p = test::drawTouchingPair<T>(random), q = test::exchanged(p);
        const auto a = laws::touchEffect(p.geometry, p.law, p.motion, p.spring, T(1e-4));
        const auto b = laws::touchEffect(q.geometry, q.law, q.motion, q.spring, T(1e-4));
        ASSERT_TRUE(opposite(a.load.force, b.load.force));
        ASSERT_TRUE(opposite(a.spring, b.spring));
        ASSERT_TRUE(opposite(a.damping.force, b.damping.force));
        ASSERT_TRUE(opposite(a.friction.force, b.friction.force));
        ASSERT_EQ(a.spring_energy, b.spring_energy);
        // Torques act at one common point: arm x force from each side, and opposite rolling torques.
        const auto roll = laws::rollingTorque(p.law.rolling, p.law.radius, p.law.elastic, p.law.inertia,
                                              p.motion.spin_j - p.motion.spin_i, T(1e-4));
        const auto back = laws::rollingTorque(q.law.rolling, q.law.radius, q.law.elastic, q.law.inertia,
                                              q.motion.spin_j - q.motion.spin_i, T(1e-4));
        ASSERT_TRUE(opposite(roll, back));
        pulled_off += dot(a.load.force, p.geometry.normal) > T(0);
    }
    EXPECT_GT(pulled_off, 0);
    EXPECT_LT(pulled_off, kPairs);
}

TEST(Exchange, ContactsGiveExactOpposites) {
    expectTouchesOdd<float>();
    expectTouchesOdd<double>();
}

TEST(Exchange, ConstantsOfAPairAreTheSameFromBothSides) {
    const auto a = laws::contactModuli(7e9, 0.2, 3e10, 0.31), b = laws::contactModuli(3e10, 0.31, 7e9, 0.2);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.tangential, b.tangential);
    EXPECT_EQ(laws::reduced(0.3f, 0.7f), laws::reduced(0.7f, 0.3f));
    EXPECT_NEAR(sphereBondRadius(0.5, 0.3, 0.7) / sphereBondRadius(0.5, 0.7, 0.3), 1, 1e-15);
    const auto k = beamBond(4e6, 1.1e-3, 0.05);
    const test::BondEnd light{0.2, 3e-5, 7, 0.02}, heavy{0.9, 2e-4, 11, 0.03};
    EXPECT_NEAR(test::frequencyBoundSquared(k, light, heavy) / test::frequencyBoundSquared(k, heavy, light),
                1, 1e-14);
}

TEST(Exchange, ContactLawsOfAPairAreTheSameFromBothSides) {
    for (const uint32_t hertz : {0u, 1u}) {
        PairLaw<float> pair{1e5f, 0.7f, 0.4f, 0.3f, 0.2f, 2e7f, 8e6f};
        StepParams<float> params;
        params.hertz = hertz;
        params.stiffness_cap = 1e6f;
        const float m_i = 0.3f, m_j = 0.05f, r_i = 0.04f, r_j = 0.02f;
        const auto a = laws::contactTouchLaw(pair, params, 1e-3f, laws::reduced(r_i, r_j),
                                             PairInertia<float>{1 / m_i + 1 / m_j, 7.0f});
        const auto b = laws::contactTouchLaw(pair, params, 1e-3f, laws::reduced(r_j, r_i),
                                             PairInertia<float>{1 / m_j + 1 / m_i, 7.0f});
        EXPECT_EQ(a.elastic, b.elastic);
        EXPECT_EQ(a.normal_damping, b.normal_damping);
        EXPECT_EQ(a.shear, b.shear);
        EXPECT_EQ(a.adhesion, b.adhesion);
    }
}

TEST(Exchange, ARigidFragmentsParticleCountsAlikeFromBothSides) {
    const ParticleConstants<float> fast{3.0f, 700.0f, 0.01f, 0.01f},
        slow = ParticleConstants<float>{0.5f, 90.0f, 0.01f, 0.01f}.seenByOther();
    const auto a = laws::pairInertia(fast, slow), b = laws::pairInertia(slow, fast);
    EXPECT_EQ(a.inverse_mass, b.inverse_mass);
    EXPECT_EQ(a.inverse_inertia, b.inverse_inertia);
    EXPECT_EQ(a.stiffness_share, b.stiffness_share);
    EXPECT_EQ(a.damping_share, b.damping_share);
    EXPECT_TRUE(a.softens && b.softens);
    EXPECT_FLOAT_EQ(a.inverse_mass, 3.5f);
    // What the fragment's long step allows, in units of what a short one allows the reduced mass.
    EXPECT_FLOAT_EQ(a.stiffness_share, 3.5f / (3.0f + 100 * 0.5f));
    EXPECT_FLOAT_EQ(a.damping_share, 3.5f / (3.0f + 10 * 0.5f));
    const auto both = laws::pairInertia(fast, fast);
    EXPECT_EQ(both.stiffness_share, 1);
    EXPECT_EQ(both.inverse_mass, 6.0f);
    EXPECT_FALSE(both.softens);
}

TEST(Exchange, StateOfAPairDependsOnItsDistanceAlone) {
    std::mt19937 random(3);
    for (int k = 0; k < kPairs; ++k) {
        const auto u = test::drawVector<float>(random, 1);
        ASSERT_EQ(laws::nextState(PairState::kBroken, false, length(u), 0.7f),
                  laws::nextState(PairState::kBroken, false, length(-u), 0.7f));
        ASSERT_EQ(laws::brokenOverlap(0.7f, length(u)), laws::brokenOverlap(0.7f, length(-u)));
        ASSERT_EQ(laws::isDiscrete(length(u), 0.7f, 0.01f), laws::isDiscrete(length(-u), 0.7f, 0.01f));
        const Vec3<float> moment = test::drawVector<float>(random, 1);
        ASSERT_TRUE(opposite(laws::cappedBendingMoment(moment, 0.25f, 2.0f, 0.5f),
                             laws::cappedBendingMoment(-moment, 0.25f, 2.0f, 0.5f)));
    }
}

/// Kinematics, energy and verdict of a bond, one by one.
TEST(Exchange, ABondsEnergyAndBreakAreTheSameFromBothSides) {
    std::mt19937 random(5);
    int broken = 0;
    for (int k = 0; k < 300; ++k) {
        const auto p = test::drawBondedPair<double>(random), q = test::exchanged(p);
        const auto a = laws::bondDeformation(p.bond.rest, p.motion),
                   b = laws::bondDeformation(q.bond.rest, q.motion);
        ASSERT_EQ(a.stretch, b.stretch);
        ASSERT_EQ(a.twist, b.twist);
        ASSERT_TRUE(opposite(a.shear, b.shear));
        ASSERT_EQ(laws::bondEnergy(p.bond.stiffness, a), laws::bondEnergy(q.bond.stiffness, b));
        const auto severity = [&](const BondDeformation<double>& d) {
            return laws::bondSeverity(laws::bondLoad(p.bond.stiffness, d), p.bond.radius);
        };
        const double limit = laws::severityLimit(p.bond.strength, p.bond.radius);
        ASSERT_EQ(severity(a), severity(b));
        broken += laws::bondBreaks(severity(a), limit);
    }
    EXPECT_GT(broken, 10);
    EXPECT_LT(broken, 290);
}

TEST(Exchange, BrokenFacesCountAlikeFromBothSides) {
    const ParticleConstants<float> light{3.0f, 700.0f, 0.01f, 0.01f}, heavy{0.5f, 90.0f, 0.02f, 0.02f},
        rigid = heavy.seenByOther();
    const FaceLaw<float> law{0.5f, 0.1f, 0.2f};
    const BondConstants<float> bond{{0.05f, 0, 0}, {8e4f, 2.4e4f, 6.4f, 3.8f}, 0.0178f, 6e4f, 1e-4f};
    StepParams<float> params;
    params.dt = 1e-4f;
    params.stiffness_cap = params.face_cap = 1e5f;
    for (const ParticleConstants<float>& other : {heavy, rigid}) {
        const auto seen = [&](const ParticleConstants<float>& i, const ParticleConstants<float>& j) {
            const auto against = laws::pairInertia(i, j);
            const auto faces = laws::cappedFaces(bond, params, against, 0.0f);
            return laws::brokenTouchLaw(faces, law, params, 1e-4f,
                                        laws::reduced(i.contact_radius, j.contact_radius), against);
        };
        const TouchLaw<float> a = seen(light, other), b = seen(other, light);
        EXPECT_LT(a.stiffness, 8e4f) << "it is capped";
        EXPECT_EQ(a.stiffness, b.stiffness);
        EXPECT_EQ(a.elastic, b.elastic);
        EXPECT_EQ(a.normal_damping, b.normal_damping);
        EXPECT_EQ(a.shear, b.shear);
        EXPECT_EQ(a.adhesion, b.adhesion);
        EXPECT_EQ(a.inertia, b.inertia);
    }
}

TEST(Exchange, TwoPiecesWakeAlike) {
    const WakeLaw<float> glass{1.2f, 2.0f, 400.0f}, stone{2.5f, 3.0f, 900.0f};
    for (const float n : {1.0f, 30.0f, 400.0f})
        for (const float m : {2.0f, 250.0f, 900.0f})
            EXPECT_EQ(laws::wakeSpeed(glass, stone, n, m), laws::wakeSpeed(stone, glass, m, n));
}

TEST(Exchange, AFragmentsMotionDoesNotDependOnTheOrderOfItsParticles) {
    std::mt19937 random(4);
    struct Body {
        double mass;
        Vec3<double> x, v, w;
    };
    std::vector<Body> bodies;
    for (int k = 0; k < 60; ++k)
        bodies.push_back({1 + 0.3 * test::drawVector<double>(random, 1).x,
                          test::drawVector<double>(random, 1), test::drawVector<double>(random, 3),
                          test::drawVector<double>(random, 5)});
    const auto fit = [&] {
        MassSums sums;
        for (const Body& b : bodies) sums = sums + laws::massOf(b.mass, b.x, b.v);
        SpinSums spins;
        for (const Body& b : bodies)
            spins = spins + laws::spinOf(b.mass, 0.01, b.x - laws::massCentre(sums),
                                         b.v - laws::meanVelocity(sums), b.w);
        return laws::rigidMotion(sums, spins);
    };
    const RigidMotion forward = fit();
    std::reverse(bodies.begin(), bodies.end());
    const RigidMotion backward = fit();
    EXPECT_LT(length(forward.centre - backward.centre), 1e-14);
    EXPECT_LT(length(forward.velocity - backward.velocity), 1e-14);
    EXPECT_LT(length(forward.spin - backward.spin), 1e-13);
}

}  // namespace
}  // namespace demolish
