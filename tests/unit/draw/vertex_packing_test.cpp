// SPDX-License-Identifier: Apache-2.0
// Packed directions and halves come back as they went in, within the step of their format.
#include "sim_cuda/physics/vertex_packing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/draw/vertex_unpacking.h"

namespace demolish {
namespace {

TEST(VertexPacking, EveryFiniteHalfSurvives) {
    for (uint32_t half = 0; half < 0x10000u; ++half) {
        if ((half & 0x7c00u) == 0x7c00u) continue;  // infinities and NaN are not made
        EXPECT_EQ(packHalf(test::unpackHalf(half)), half) << std::hex << half;
    }
}

TEST(VertexPacking, HalfRoundsToNearestEvenAndStopsAtTheLargest) {
    EXPECT_EQ(packHalf(1.0f + 1.0f / 2048), 0x3c00u);  // a tie goes to the even neighbour below
    EXPECT_EQ(packHalf(1.0f + 3.0f / 2048), 0x3c02u);  // and above
    EXPECT_EQ(packHalf(1.0f + 1.01f / 2048), 0x3c01u);
    EXPECT_EQ(packHalf(1e9f), 0x7bffu);
    EXPECT_EQ(packHalf(-1e9f), 0xfbffu);
    EXPECT_EQ(packHalf(std::nanf("")), 0u);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> exponent(-14, 15);
    for (int n = 0; n < 10'000; ++n) {
        const float value = std::exp2(exponent(random));
        EXPECT_LE(std::abs(test::unpackHalf(packHalf(value)) - value), value / 2048);
    }
}

TEST(VertexPacking, DirectionsComeBackWithinAFewThousandthsOfADegree) {
    std::mt19937 random(6);
    std::normal_distribution<float> gauss;
    for (int n = 0; n < 20'000; ++n) {
        float x = gauss(random), y = gauss(random), z = gauss(random);
        const float length = std::sqrt(x * x + y * y + z * z);
        x /= length, y /= length, z /= length;
        float u, v, w;
        test::unpackOctahedral(packOctahedral(3 * x, 3 * y, 3 * z), u, v, w);
        const float back = std::sqrt(u * u + v * v + w * w);
        EXPECT_LT(std::hypot(u / back - x, v / back - y, w / back - z), 1e-4f) << x << ' ' << y << ' ' << z;
    }
}

TEST(VertexPacking, AxesAreExact) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            float in[3] = {0, 0, 0}, out[3];
            in[axis] = sign;
            test::unpackOctahedral(packOctahedral(in[0], in[1], in[2]), out[0], out[1], out[2]);
            for (int c = 0; c < 3; ++c) EXPECT_EQ(out[c], in[c]) << axis << ' ' << c;
        }
    }
}

}  // namespace
}  // namespace demolish
