// SPDX-License-Identifier: Apache-2.0
// Joined parts: order, mirroring, carving, and the short cut past far parts.
#include "assets/models/field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace demolish::sculptor {
namespace {

Part ball(Vec3 centre, double radius, double blend = 0) {
    Part part;
    part.a = centre;
    part.radii = {radius, radius, radius};
    part.blend = blend;
    return part;
}

TEST(Field, JoinsMirrorsAndCarves) {
    FieldRecipe recipe;
    recipe.parts = {ball({0, 0, 0}, 2), ball({3, 0, 0}, 1), ball({0, 2, 0}, 1)};
    recipe.parts[1].mirrored = true;
    recipe.parts[2].carves = true;
    const Field field(recipe);
    EXPECT_DOUBLE_EQ(field.at({6, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(field.at({-6, 0, 0}), 2);
    EXPECT_DOUBLE_EQ(field.at({0, 2, 0}), 1) << "inside the carved ball, 1 from its wall";
    EXPECT_DOUBLE_EQ(field.at({0, -1, 0}), -1);
    EXPECT_LE(field.bounds().low.x, -4);
    EXPECT_GE(field.bounds().high.x, 4);
}

TEST(Field, SkippingFarPartsDoesNotChangeABit) {
    FieldRecipe recipe =
        std::get<FieldRecipe>(readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/wolf.toml").body);
    recipe.coat.reset();
    const Field field(recipe);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-25, 25), y(-5, 110), z(-75, 90);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 p{x(random), y(random), z(random)};
        double body = 0;
        for (std::size_t k = 0; k < recipe.parts.size(); ++k) {
            FieldRecipe single;
            single.parts = {recipe.parts[k]};
            single.parts[0].carves = false;
            const double d = Field(single).at(p);
            const Part& part = recipe.parts[k];
            body = k == 0        ? d
                   : part.carves ? smoothSubtraction(body, d, part.blend)
                                 : smoothUnion(body, d, part.blend);
        }
        ASSERT_EQ(field.at(p), body) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

TEST(Field, GradientOfABallPointsOutwards) {
    FieldRecipe recipe;
    recipe.parts = {ball({1, 2, 3}, 2)};
    const Vec3 gradient = Field(recipe).gradient({1, 7, 3}, 0.01);
    EXPECT_NEAR(gradient.x, 0, 1e-9);
    EXPECT_NEAR(gradient.y, 1, 1e-9);
    EXPECT_NEAR(gradient.z, 0, 1e-9);
}

TEST(Coat, NoiseFillsItsRangeAndIsContinuous) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> c(-50, 50);
    double least = 1, most = 0, sum = 0;
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) {
        const Vec3 p{c(random), c(random), c(random)};
        const double n = valueNoise(p);
        least = std::min(least, n), most = std::max(most, n), sum += n;
        EXPECT_NEAR(valueNoise(p + Vec3{1e-6, 1e-6, 1e-6}), n, 1e-5);
    }
    EXPECT_GE(least, 0);
    EXPECT_LE(most, 1);
    EXPECT_LT(least, 0.1);
    EXPECT_GT(most, 0.9);
    EXPECT_NEAR(sum / kPoints, 0.5, 0.02);
}

TEST(Coat, FadesOutWhereTheRecipeSays) {
    const FieldRecipe recipe =
        std::get<FieldRecipe>(readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/wolf.toml").body);
    const Coat& coat = *recipe.coat;
    EXPECT_EQ(coatRelief(coat, {3, 30, 10}), 0) << "the legs are bare";
    EXPECT_EQ(coatRelief(coat, {3, 85, 70}), 0) << "the face is bare";
    double deepest = 0, highest = 0;
    for (double x = -10; x < 10; x += 0.37) {
        deepest = std::min(deepest, coatRelief(coat, {x, 70, 20}));
        highest = std::max(highest, coatRelief(coat, {x, 70, 20}));
    }
    EXPECT_LT(deepest, -0.05);
    EXPECT_GT(highest, 0.1);
}

}  // namespace
}  // namespace demolish::sculptor
