// The arithmetic under the laws: own inverse square root, quaternions, exact oddness.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "sim_cuda/physics/quaternion.h"
#include "tests/physics/laws/bonded_set.h"

namespace demolish {
namespace {

TEST(InverseSqrt, IsWithinItsBoundOverAllMantissasOfTwoOctaves) {
    double worst = 0;
    for (uint32_t bits = 0x3f000000u; bits < 0x40000000u; bits += 7) {
        const float x = std::bit_cast<float>(bits);
        worst = std::max(worst, std::abs(inverseSqrt(x) * std::sqrt(double(x)) - 1));
    }
    EXPECT_LE(worst, 7.6e-8);
    EXPECT_GT(worst, 1e-8);
}

TEST(InverseSqrt, HoldsOverTheWholeRangeOfNormalNumbers) {
    for (int exponent = -125; exponent < 128; ++exponent) {
        const float x = std::ldexp(1.37f, exponent);
        EXPECT_NEAR(inverseSqrt(x) * std::sqrt(double(x)), 1, 7.6e-8) << x;
    }
}

TEST(InverseSqrt, GuardsZeroDenormalsAndNegativesButNotNaN) {
    EXPECT_EQ(inverseSqrt(0.0f), 0.0f);
    EXPECT_EQ(inverseSqrt(-1.0f), 0.0f);
    EXPECT_EQ(inverseSqrt(std::numeric_limits<float>::denorm_min()), 0.0f);
    EXPECT_EQ(squareRoot(0.0f), 0.0f);
    EXPECT_TRUE(std::isnan(inverseSqrt(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(inverseSqrt(std::numeric_limits<float>::infinity())));
    EXPECT_EQ(inverseSqrt(0.0), 0.0);
    EXPECT_DOUBLE_EQ(inverseSqrt(4.0), 0.5);
}

template <class T>
Quat<T> randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return normalized(Quat<T>{T(normal(random)), T(normal(random)), T(normal(random)), T(normal(random))});
}

TEST(Quaternion, RelativeRotationTurnsOneOrientationIntoTheOther) {
    std::mt19937 random(3);
    for (int k = 0; k < 100; ++k) {
        const auto a = randomRotation<double>(random), b = randomRotation<double>(random);
        const auto back = multiply(relativeRotation(a, b), a);
        EXPECT_NEAR(back.x, b.x, 1e-14);
        EXPECT_NEAR(back.w, b.w, 1e-14);
    }
}

template <class T>
void expectExactOddness() {
    std::mt19937 random(4);
    for (int k = 0; k < 2000; ++k) {
        const auto a = randomRotation<T>(random), b = randomRotation<T>(random);
        const auto ab = relativeRotation(a, b), ba = relativeRotation(b, a);
        ASSERT_EQ(ab.x, -ba.x);
        ASSERT_EQ(ab.y, -ba.y);
        ASSERT_EQ(ab.z, -ba.z);
        ASSERT_EQ(ab.w, ba.w);
        const Vec3<T> v = vectorPart(b), forward = rotate(a, v), backward = rotate(a, -v);
        ASSERT_EQ(forward.x, -backward.x);
        ASSERT_EQ(forward.y, -backward.y);
        ASSERT_EQ(forward.z, -backward.z);
    }
}
TEST(Quaternion, ExchangeNegatesTheRelativeRotationToTheBit) {
    expectExactOddness<float>();
    expectExactOddness<double>();
}

TEST(Quaternion, ExponentialIsExactToRoundOff) {
    for (const double h : {0.0, 1e-6, 1e-3, 0.05, 0.25, 0.5}) {
        const auto q = exponential(Vec3<double>{h * 0.6, h * 0.0, h * 0.8});
        EXPECT_NEAR(q.w, std::cos(h), 2e-16);
        EXPECT_NEAR(q.z, 0.8 * std::sin(h), 2e-16);
        const auto f = exponential(Vec3<float>{float(h * 0.6), 0.0f, float(h * 0.8)});
        EXPECT_NEAR(f.w, std::cos(h), 1.2e-7);
        EXPECT_NEAR(f.z, 0.8 * std::sin(h), 1.2e-7);
    }
}

TEST(Quaternion, SpinningAboutAFixedAxisComesRound) {
    Quat<double> q;
    const int steps = 1000;
    for (int k = 0; k < steps; ++k) q = advanced(q, Vec3<double>{0, 2 * kPi, 0}, 1.0 / steps);
    EXPECT_NEAR(std::abs(q.w), 1, 1e-13);
    EXPECT_NEAR(q.y, 0, 1e-12);
    const auto quarter = rotate(test::turn(Vec3<double>{0, 0, 1}, kPi / 2), Vec3<double>{1, 0, 0});
    EXPECT_NEAR(quarter.y, 1, 1e-15);
}

}  // namespace
}  // namespace demolish
