// SPDX-License-Identifier: Apache-2.0
// Beside a rasteriser of the test's own: what that draws is never denied, and most of the rest is.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/render/sample_grid.h"

namespace demolish::engine {
namespace {

constexpr int kWidth = 64, kHeight = 48;
const std::vector<glm::vec2> kFour = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};

glm::dvec2 snapped(const PicturePoint& p) {
    return {std::round(256.0 * p.x) / 256, std::round(256.0 * p.y) / 256};
}

/// Samples inside or on an edge of the counter-clockwise triangle, corners rounded to 1/256 px.
bool drawsOne(const PicturePoint (&corner)[3], const std::vector<glm::vec2>& samples) {
    glm::dvec2 p[3];
    for (int k = 0; k < 3; ++k) p[k] = snapped(corner[k]);
    const auto side = [&](int from, const glm::dvec2& at) {
        const glm::dvec2 edge = p[(from + 1) % 3] - p[from], away = at - p[from];
        return edge.x * away.y - edge.y * away.x;
    };
    if (side(0, p[2]) <= 0) return false;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (const glm::vec2& sample : samples) {
                const glm::dvec2 at(x + sample.x, y + sample.y);
                if (side(0, at) >= 0 && side(1, at) >= 0 && side(2, at) >= 0) return true;
            }
    return false;
}

PicturePoint at(float x, float y, float w = 1) {
    return {x, y, w};
}

TEST(SampleGrid, DeniesNothingThatIsDrawnAndMostOfTheRest) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-1, 66), size(-1, 1);
    for (const auto& samples : {kFour, std::vector<glm::vec2>{{0.5f, 0.5f}}}) {
        const SampleGrid grid(glm::mat4(1), kWidth, kHeight, samples);
        int drawn = 0, hidden = 0, denied = 0;
        for (int k = 0; k < 4000; ++k) {
            const float x = place(random), y = place(random), extent = k % 2 == 0 ? 0.6f : 6.0f;
            PicturePoint corner[3];
            for (PicturePoint& p : corner) p = at(x + extent * size(random), y + extent * size(random));
            const bool shows = drawsOne(corner, samples);
            const bool may = grid.mayShow(corner[0], corner[1], corner[2], false);
            EXPECT_TRUE(may || !shows) << k;
            drawn += shows ? 1 : 0;
            hidden += shows ? 0 : 1;
            denied += may ? 0 : 1;
        }
        EXPECT_GT(drawn, 500);
        EXPECT_GT(denied, 0.9 * hidden);
    }
}

TEST(SampleGrid, BacksCountWhereTheyAreSeen) {
    const SampleGrid grid(glm::mat4(1), kWidth, kHeight);
    const PicturePoint a = at(10, 10), b = at(12, 10), c = at(10, 12);
    EXPECT_TRUE(grid.mayShow(a, b, c, false));
    EXPECT_FALSE(grid.mayShow(a, c, b, false));
    EXPECT_TRUE(grid.mayShow(a, c, b, true));
}

TEST(SampleGrid, WhatHasNoPlaceOnThePictureIsNotDenied) {
    const SampleGrid grid(glm::mat4(1), kWidth, kHeight);
    const float nan = std::nanf("");
    EXPECT_TRUE(grid.mayShow(at(10, 10), at(12, 10, -1), at(10, 12), false));
    EXPECT_TRUE(grid.mayShow(at(nan, 10), at(12, 10), at(10, 12), false));
    EXPECT_TRUE(grid.mayShow(at(-1e30f, 10), at(1e30f, 10), at(10, 1e30f), false));
}

TEST(SampleGrid, OfAThinTriangleEverySampleOnItsWayCounts) {
    const SampleGrid grid(glm::mat4(1), kWidth, kHeight);
    EXPECT_TRUE(grid.mayShow(at(10.5f, 10.5f), at(13.5f, 10.501f), at(10.5f, 10.501f), false));
    EXPECT_FALSE(grid.mayShow(at(10.6f, 10.0f), at(10.9f, 10.0f), at(10.6f, 13.0f), false));
}

TEST(SampleGrid, PlacesAreThoseOfTheViewport) {
    const SampleGrid grid(glm::mat4(2), kWidth, kHeight);  // w = 2: perspective
    const PicturePoint p = grid.projectionOf(glm::mat4(1)).placeOf({0.5f, -1, 0});
    EXPECT_FLOAT_EQ(p.x, 0.75f * kWidth);
    EXPECT_FLOAT_EQ(p.y, 0);
    EXPECT_FLOAT_EQ(p.w, 2);
}

TEST(SampleGrid, FarFromTheOriginPlacesAreLessSure) {
    const SampleGrid grid(glm::mat4(1), kWidth, kHeight);
    const auto moved = [&](float by) {
        glm::mat4 motion(1);
        motion[3].x = by;
        return grid.projectionOf(motion).placeOf({0.5f - by, 0, 0});
    };
    EXPECT_FLOAT_EQ(moved(16).x, moved(0).x);
    EXPECT_LT(moved(0).unsure, 1.0f / 300);
    EXPECT_GT(moved(1e4f).unsure, 1e4f * 6e-8f * kWidth / 2);
}

}  // namespace
}  // namespace demolish::engine
