// SPDX-License-Identifier: Apache-2.0
// Tangential spring, Coulomb cap and rolling resistance: magnitudes capped, directions right, odd under
// exchange.
#include <gtest/gtest.h>

#include <random>

#include "sim_cuda/physics/rolling_resistance.h"
#include "sim_cuda/physics/tangential_spring.h"
#include "tests/physics/laws/laws.h"

namespace demolish {
namespace {
using V = Vec3<double>;

TEST(TangentialSpring, HoldsBelowTheLimitAndFollowsTheSlip) {
    V spring;
    for (int k = 0; k < 10; ++k)
        spring = laws::tangentialSpring(spring, V{0, 1, 0}, V{0.1, 0, 0}, 1e-3, 1e4, 0.0, 100.0).spring;
    const auto result = laws::tangentialSpring(spring, V{0, 1, 0}, V{}, 1e-3, 1e4, 0.0, 100.0);
    EXPECT_FALSE(result.sliding);
    EXPECT_NEAR(result.spring.x, 1e-3, 1e-15);
    EXPECT_NEAR(result.force.x, 10, 1e-10);  // i is dragged along by j
}

TEST(TangentialSpring, SlidesAtTheLimitInTheDirectionOfTheSlip) {
    const double limit = 4;
    const auto result = laws::tangentialSpring(V{1e-2, 0, 0}, V{0, 1, 0}, V{3, 0, 4}, 1e-1, 1e4, 0.0, limit);
    EXPECT_TRUE(result.sliding);
    EXPECT_NEAR(length(result.force), limit, 1e-12);
    EXPECT_NEAR(length(result.spring), limit / 1e4, 1e-16);
    EXPECT_NEAR(result.force.z / result.force.x, 0.4 / 0.31, 1e-12);
}

TEST(TangentialSpring, NoNormalForceMeansNoFriction) {
    const auto result = laws::tangentialSpring(V{1e-2, 0, 0}, V{0, 1, 0}, V{1, 0, 0}, 1e-3, 1e4, 0.0, 0.0);
    EXPECT_EQ(length(result.force), 0);
    EXPECT_EQ(length(result.spring), 0);
}

TEST(TangentialSpring, TakesInWhatItsSpringHoldsMore) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double stiffness = 50, dt = 0.1;
    for (int k = 0; k < 5000; ++k) {
        const double damping = k % 2 == 0 ? 0 : 20 * (1 + uniform(random)), limit = 3 * (1 + uniform(random));
        const V spring = (0.1 * uniform(random)) * V{1, 0, 0}, slip{uniform(random), 0, uniform(random)};
        const auto result = laws::tangentialSpring(spring, V{0, 1, 0}, slip, dt, stiffness, damping, limit);
        const double taken = dt * dot(result.force, slip),
                     held = 0.5 * stiffness * (length2(result.spring) - length2(spring));
        ASSERT_GE(taken, held - 1e-12) << "spring " << spring.x << ", slip " << slip.x << " " << slip.z
                                       << ", damping " << damping << ", limit " << limit;
    }
}

TEST(TangentialSpring, TurnsWithTheContactPlaneAndKeepsItsLength) {
    const V spring{1e-3, 2e-3, 0}, normal = normalized(V{0, 0.2, 1});
    const V turned = laws::turnedIntoPlane(spring, normal);
    EXPECT_NEAR(dot(turned, normal), 0, 1e-18);
    EXPECT_NEAR(length(turned), length(spring), 1e-17);
    EXPECT_EQ(length(laws::turnedIntoPlane(V{}, normal)), 0);
}

template <class T>
void expectOdd() {
    std::mt19937 random(5);
    std::uniform_real_distribution<T> uniform(-1, 1);
    const auto draw = [&] { return Vec3<T>{uniform(random), uniform(random), uniform(random)}; };
    for (int k = 0; k < 2000; ++k) {
        const auto spring = draw(), normal = normalized(draw()), slip = draw(), spin = draw();
        const T limit = T(0.5) + uniform(random) / 2;
        const auto forward = laws::tangentialSpring(spring, normal, slip, T(0.1), T(2), T(0.3), limit);
        const auto backward = laws::tangentialSpring(-spring, -normal, -slip, T(0.1), T(2), T(0.3), limit);
        ASSERT_EQ(forward.sliding, backward.sliding);
        ASSERT_EQ(forward.force.x, -backward.force.x);
        ASSERT_EQ(forward.force.y, -backward.force.y);
        ASSERT_EQ(forward.spring.z, -backward.spring.z);
        ASSERT_LE(length(forward.force), limit * T(1.000001));
        const auto roll = laws::rollingTorque(T(0.3), T(1), T(2), T(0.1), spin, T(0.01));
        const auto back = laws::rollingTorque(T(0.3), T(1), T(2), T(0.1), -spin, T(0.01));
        ASSERT_EQ(roll.x, -back.x);
        ASSERT_EQ(roll.y, -back.y);
    }
}
TEST(Friction, ExchangeOfTheTwoParticlesNegatesItToTheBit) {
    expectOdd<float>();
    expectOdd<double>();
}

TEST(RollingResistance, IsTheSmallerOfCoulombAndAFifthOfTheSpinPerStep) {  // models E.5
    const V spin{0, 0, 10};
    EXPECT_NEAR(laws::rollingTorque(0.3, 0.02, 5.0, 1e-3, spin, 1e-3).z, 0.3 * 0.02 * 5, 1e-15);
    EXPECT_NEAR(laws::rollingTorque(0.3, 0.02, 5e6, 1e-3, spin, 1e-3).z, 0.2 * 1e-3 * 10 / 1e-3, 1e-12);
    EXPECT_EQ(length(laws::rollingTorque(0.3, 0.02, 5.0, 1e-3, V{}, 1e-3)), 0);
}

}  // namespace
}  // namespace demolish
