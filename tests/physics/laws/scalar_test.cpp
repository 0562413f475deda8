// SPDX-License-Identifier: Apache-2.0
// The arithmetic under the laws: own inverse square root, quaternions, exact oddness.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "sim_cuda/physics/quaternion.h"
#include "tests/physics/laws/bonded_set.h"

namespace demolish {
namespace {

/// 1/sqrt of every seventh float from 0.5 to 2.
constexpr uint32_t kFirst = 0x3f000000u, kEnd = 0x40000000u, kStride = 7;
struct InverseRoots {
    float* out;
    DEM_FN void operator()(size_t k) const {
        out[k] = inverseSqrt(std::bit_cast<float>(kFirst + kStride * static_cast<uint32_t>(k)));
    }
};

TEST(InverseSqrt, IsWithinItsBoundOverAllMantissasOfTwoOctaves) {
    laws::Shared<float> roots((kEnd - kFirst) / kStride);
    laws::forEach(roots.size(), InverseRoots{roots.data()});
    double worst = 0;
    for (size_t k = 0; k < roots.size(); ++k) {
        const float x = std::bit_cast<float>(kFirst + kStride * static_cast<uint32_t>(k));
        worst = std::max(worst, std::abs(roots[k] * std::sqrt(double(x)) - 1));
    }
    EXPECT_LE(worst, 7.6e-8);
    EXPECT_GT(worst, 1e-8);
}

TEST(InverseSqrt, HoldsOverTheWholeRangeOfNormalNumbers) {
    for (int exponent = -125; exponent < 128; ++exponent) {
        const float x = std::ldexp(1.37f, exponent);
        EXPECT_NEAR(laws::inverseSqrt(x) * std::sqrt(double(x)), 1, 7.6e-8) << x;
    }
}

TEST(InverseSqrt, GuardsZeroDenormalsAndNegativesButNotNaN) {
    EXPECT_EQ(laws::inverseSqrt(0.0f), 0.0f);
    EXPECT_EQ(laws::inverseSqrt(-1.0f), 0.0f);
    EXPECT_EQ(laws::inverseSqrt(std::numeric_limits<float>::denorm_min()), 0.0f);
    EXPECT_EQ(laws::squareRoot(0.0f), 0.0f);
    EXPECT_TRUE(std::isnan(laws::inverseSqrt(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(laws::inverseSqrt(std::numeric_limits<float>::infinity())));
    EXPECT_EQ(laws::inverseSqrt(0.0), 0.0);
    EXPECT_DOUBLE_EQ(laws::inverseSqrt(4.0), 0.5);
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
        const auto back = laws::multiply(laws::relativeRotation(a, b), a);
        EXPECT_NEAR(back.x, b.x, 1e-14);
        EXPECT_NEAR(back.w, b.w, 1e-14);
    }
}

template <class T>
void expectExactOddness() {
    std::mt19937 random(4);
    for (int k = 0; k < 2000; ++k) {
        const auto a = randomRotation<T>(random), b = randomRotation<T>(random);
        const auto ab = laws::relativeRotation(a, b), ba = laws::relativeRotation(b, a);
        ASSERT_EQ(ab.x, -ba.x);
        ASSERT_EQ(ab.y, -ba.y);
        ASSERT_EQ(ab.z, -ba.z);
        ASSERT_EQ(ab.w, ba.w);
        const Vec3<T> v = vectorPart(b), forward = laws::rotate(a, v), backward = laws::rotate(a, -v);
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
        const auto q = laws::exponential(Vec3<double>{h * 0.6, h * 0.0, h * 0.8});
        EXPECT_NEAR(q.w, std::cos(h), 2e-16);
        EXPECT_NEAR(q.z, 0.8 * std::sin(h), 2e-16);
        const auto f = laws::exponential(Vec3<float>{float(h * 0.6), 0.0f, float(h * 0.8)});
        EXPECT_NEAR(f.w, std::cos(h), 1.2e-7);
        EXPECT_NEAR(f.z, 0.8 * std::sin(h), 1.2e-7);
    }
}

TEST(Quaternion, SpinningAboutAFixedAxisComesRound) {
    Quat<double> q;
    const int steps = 1000;
    for (int k = 0; k < steps; ++k) q = laws::advanced(q, Vec3<double>{0, 2 * kPi, 0}, 1.0 / steps);
    EXPECT_NEAR(std::abs(q.w), 1, 1e-13);
    EXPECT_NEAR(q.y, 0, 1e-12);
    const auto quarter = laws::rotate(test::turn(Vec3<double>{0, 0, 1}, kPi / 2), Vec3<double>{1, 0, 0});
    EXPECT_NEAR(quarter.y, 1, 1e-15);
}

}  // namespace
}  // namespace demolish
