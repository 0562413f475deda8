// SPDX-License-Identifier: Apache-2.0
// Small triangles that share edges cover each sample once, and depth follows their corners.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "engine/render/small_raster.h"

namespace demolish::engine {
namespace {

constexpr int kWidth = 16, kHeight = 12;

PictureSamples samplesOf(std::vector<glm::ivec2> at) {
    return {kWidth, kHeight, std::move(at)};
}
const PictureSamples kMiddles = samplesOf({{128, 128}}),
                     kFour = samplesOf({{96, 32}, {224, 96}, {32, 160}, {160, 224}});

float areaOf(const FlatCorners& c) {
    return (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
}

/// How often each sample is covered.
std::vector<int> covered(const std::vector<FlatCorners>& triangles, const PictureSamples& samples) {
    std::vector<int> times(kWidth * kHeight * samples.at.size());
    for (const FlatCorners& triangle : triangles)
        coverSamples(triangle, samples, [&](int x, int y, size_t k, int at_x, int at_y) {
            EXPECT_EQ(at_x, kGridSteps * x + samples.at[k].x);
            EXPECT_EQ(at_y, kGridSteps * y + samples.at[k].y);
            ++times[static_cast<size_t>(y * kWidth + x) * samples.at.size() + k];
        });
    return times;
}

/// A net over the picture and beyond, its inner nodes moved at random, by `step` grid steps each: many lie on
/// samples.
std::vector<FlatCorners> net(uint32_t seed, int step) {
    constexpr int kNodes = 10;
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> away(-100 / step, 100 / step);
    std::array<std::array<glm::vec2, kNodes>, kNodes> node;
    for (int i = 0; i < kNodes; ++i)
        for (int j = 0; j < kNodes; ++j) {
            node[i][j] = {-1024 + 640 * i, -1024 + 512 * j};
            node[i][j] += static_cast<float>(step) * glm::vec2(away(random), away(random));
        }
    std::vector<FlatCorners> triangles;
    const auto add = [&](glm::vec2 a, glm::vec2 b, glm::vec2 c) {
        triangles.push_back({{a.x, b.x, c.x}, {a.y, b.y, c.y}, {0.5f, 0.5f, 0.5f}});
        EXPECT_GT(areaOf(triangles.back()), 0);
    };
    for (int i = 0; i + 1 < kNodes; ++i)
        for (int j = 0; j + 1 < kNodes; ++j) {
            add(node[i][j], node[i + 1][j], node[i + 1][j + 1]);
            add(node[i][j], node[i + 1][j + 1], node[i][j + 1]);
        }
    return triangles;
}

TEST(SmallRaster, ANetCoversEachSampleOnce) {
    for (const PictureSamples& samples : {kMiddles, kFour})
        for (const int step : {1, 32})
            for (uint32_t seed = 0; seed < 20; ++seed)
                for (const int times : covered(net(seed, step), samples)) EXPECT_EQ(times, 1);
}

TEST(SmallRaster, WhatLiesBetweenSamplesCoversNone) {
    for (const int times : covered({{{130, 250, 130}, {130, 130, 250}, {0, 0, 0}}}, kMiddles))
        EXPECT_EQ(times, 0);
}

TEST(SmallRaster, DepthFollowsTheCorners) {
    const FlatCorners c{{0, 1024, 0}, {0, 0, 512}, {0.2f, 0.6f, 0.4f}};
    const FlatDepth depth(c, areaOf(c));
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(depth.at(static_cast<int>(c.x[k]), static_cast<int>(c.y[k])), c.depth[k], 1e-6f);
    EXPECT_NEAR(depth.at(512, 0), 0.4f, 1e-6f);
    EXPECT_NEAR(depth.steepness(), 0.1f, 1e-6f);
    EXPECT_FLOAT_EQ(depth.at(4096, 0), 0.6f) << "never beyond its corners";
}

TEST(SmallRaster, TheGreatestStays) {
    uint64_t place = 5;
    const auto less = [](uint64_t held, uint64_t value) { return held < value; };
    putIf<uint64_t>(place, 3, less);
    EXPECT_EQ(place, 5u);
    putIf<uint64_t>(place, 7, less);
    EXPECT_EQ(place, 7u);
}

}  // namespace
}  // namespace demolish::engine
