// SPDX-License-Identifier: Apache-2.0
// The roughness noise is bounded, smooth, centred, and the same on every machine.
#include "sim_cuda/physics/value_noise.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace demolish {
namespace {

TEST(ValueNoise, LatticePointsTakeTheHashedVector) {
    for (int32_t x = -3; x < 3; ++x) {
        const Vec3<float> lattice = latticeVector(x, 2 * x, -x, 7);
        const Vec3<float> noise =
            valueNoise({static_cast<float>(x), static_cast<float>(2 * x), static_cast<float>(-x)}, 7);
        EXPECT_EQ(noise.x, lattice.x);
        EXPECT_EQ(noise.y, lattice.y);
        EXPECT_EQ(noise.z, lattice.z);
    }
}

TEST(ValueNoise, RoughnessIsBoundedCentredAndSmooth) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-40, 40);
    Vec3<float> sum;
    double squares = 0;
    constexpr int kSamples = 40'000;
    for (int n = 0; n < kSamples; ++n) {
        const Vec3<float> p{place(random), place(random), place(random)};
        const Vec3<float> here = roughnessNoise(p);
        EXPECT_LE(length(here), kRoughnessNoiseBound);
        EXPECT_LT(length(roughnessNoise({p.x + 1e-3f, p.y, p.z}) - here), 0.02f)
            << "no steps, across lattice planes too";
        sum = sum + here;
        squares += length2(here);
    }
    EXPECT_LT(length(sum) / kSamples, 0.02f);
    EXPECT_GT(squares / kSamples, 0.2);
}

TEST(ValueNoise, HasTheBitsItHadWhenPicturesWereTaken) {
    EXPECT_EQ(hashLattice(1, 2, 3, 4), 0xa1bfec75u);
    const Vec3<float> noise = roughnessNoise({0.37f, -1.91f, 25.5f});
    EXPECT_EQ(std::bit_cast<uint32_t>(noise.x), 0x3e38ce4au);
}

}  // namespace
}  // namespace demolish
