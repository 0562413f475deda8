// SPDX-License-Identifier: Apache-2.0
// The shapes' distances against closed forms and against measured distances.
#include "assets/models/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace demolish::sculptor {
namespace {

Vec3 randomPoint(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return {x, y, z};
}

/// Distance to the hull of two spheres as the least of many spheres along it, each at its linear radius.
double sweptDistance(Vec3 p, Vec3 a, double ra, Vec3 b, double rb) {
    double least = length(p - a) - ra;
    constexpr int kSteps = 20000;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = double(i) / kSteps;
        least = std::min(least, length(p - (a + t * (b - a))) - (ra + t * (rb - ra)));
    }
    return least;
}

TEST(Ellipsoid, OfEqualRadiiIsASphere) {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p = randomPoint(random, 5);
        EXPECT_NEAR(ellipsoidDistance(p, {2, 2, 2}), length(p) - 2, 1e-12);
    }
    EXPECT_DOUBLE_EQ(ellipsoidDistance({}, {2, 3, 4}), -2);
}

TEST(Ellipsoid, IsZeroOnItsSurfaceWithUnitSlopeThere) {
    const Vec3 r{1.5, 2.5, 4};
    std::mt19937 random(2);
    for (int i = 0; i < 200; ++i) {
        const Vec3 d = normalized(randomPoint(random, 1));
        const Vec3 on{r.x * d.x, r.y * d.y, r.z * d.z};
        const Vec3 normal = normalized({d.x / r.x, d.y / r.y, d.z / r.z});
        EXPECT_NEAR(ellipsoidDistance(on, r), 0, 1e-12);
        EXPECT_NEAR(ellipsoidDistance(on + 1e-5 * normal, r), 1e-5, 1e-9);
        EXPECT_NEAR(ellipsoidDistance(on - 1e-5 * normal, r), -1e-5, 1e-9);
    }
}

TEST(RoundCone, EqualsTheSweptSphere) {
    const Vec3 a{1, -2, 0.5}, b{-1, 2, 3};
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
        const Vec3 p = randomPoint(random, 6);
        EXPECT_NEAR(roundConeDistance(p, a, 1.8, b, 0.6), sweptDistance(p, a, 1.8, b, 0.6), 1e-6);
        EXPECT_NEAR(roundConeDistance(p, b, 0.6, a, 1.8), roundConeDistance(p, a, 1.8, b, 0.6), 1e-12);
    }
}

TEST(RoundCone, WhoseOneEndHoldsTheOtherIsThatSphere) {
    const Vec3 a{0, 0, 0}, b{0, 0, 0.5};
    EXPECT_DOUBLE_EQ(roundConeDistance({0, 0, 5}, a, 2, b, 1), 3);
    EXPECT_DOUBLE_EQ(roundConeDistance({0, 0, 5}, a, 1, b, 2), 2.5);
}

TEST(SmoothUnion, IsPlainBeyondItsRadiusAndGrowsByAQuarterAtEqualDistance) {
    EXPECT_DOUBLE_EQ(smoothUnion(1, 3, 2), 1);
    EXPECT_DOUBLE_EQ(smoothUnion(3, 1, 0), 1);
    EXPECT_DOUBLE_EQ(smoothUnion(1, 1, 2), 0.5);
    EXPECT_DOUBLE_EQ(smoothUnion(1, 2, 2), smoothUnion(2, 1, 2));
}

TEST(SmoothSubtraction, TakesTheSecondAway) {
    EXPECT_DOUBLE_EQ(smoothSubtraction(-1, -3, 0.5), 3);
    EXPECT_DOUBLE_EQ(smoothSubtraction(-1, 5, 0.5), -1);
    EXPECT_GT(smoothSubtraction(-1, 1, 2), -1) << "the rounded edge takes more away";
}

TEST(Frame, TurnsAsTheRecipesSay) {
    EXPECT_GT(Frame::of({30, 0, 0}).z.y, 0.49) << "pitch lifts the front";
    EXPECT_GT(Frame::of({0, 30, 0}).z.x, 0.49) << "yaw turns the front to +x";
    EXPECT_LT(Frame::of({0, 0, 30}).y.x, -0.49) << "roll leans the top to -x";
    const Frame frame = Frame::of({10, 40, -70});
    EXPECT_NEAR(dot(frame.x, cross(frame.y, frame.z)), 1, 1e-10);
    EXPECT_NEAR(dot(frame.x, frame.y), 0, 1e-10);
}

}  // namespace
}  // namespace demolish::sculptor
