// SPDX-License-Identifier: Apache-2.0
// Ear clipping: exact cover, proper triangles, holes.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/authoring/face_triangulation.h"

namespace demolish::test {
namespace {

struct Cover {
    double area = 0;
    size_t flipped = 0;
};

Cover coverOf(const std::vector<PlanePoint>& points, const std::vector<uint32_t>& loop_start) {
    FaceTriangulation triangulation;
    Cover cover;
    for (const auto& [a, b, c] : triangulation.triangulate(points, loop_start)) {
        const double twice = turn(points[a], points[b], points[c]);
        cover.area += 0.5 * twice;
        cover.flipped += twice < 0;
    }
    return cover;
}

TEST(FaceTriangulation, SquareWithTwoHoles) {
    const std::vector<PlanePoint> points{{0, 0},     {4, 0},     {4, 4},     {0, 4},       // outline
                                         {1, 1},     {1, 2},     {2, 2},     {2, 1},       // hole
                                         {2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}};  // hole
    const Cover cover = coverOf(points, {0, 4, 8, 12});
    EXPECT_NEAR(cover.area, 16 - 2, 1e-12);
    EXPECT_EQ(cover.flipped, 0u);
}

TEST(FaceTriangulation, CornersOnStraightSides) {
    const std::vector<PlanePoint> points{{0, 0},   {0.3, 0}, {0.7, 0}, {1, 0},
                                         {1, 0.5}, {1, 1},   {0.5, 1}, {0, 1}};
    const Cover cover = coverOf(points, {0, 8});
    EXPECT_NEAR(cover.area, 1, 1e-14);
    EXPECT_EQ(cover.flipped, 0u);
}

TEST(FaceTriangulation, SpiralIsCoveredOnce) {
    std::vector<PlanePoint> points;
    double expected = 0;
    for (int k = 0; k < 60; ++k)
        points.push_back({(2 + 0.1 * k) * std::cos(0.2 * k), (2 + 0.1 * k) * std::sin(0.2 * k)});
    for (int k = 59; k >= 0; --k)
        points.push_back({(1.7 + 0.1 * k) * std::cos(0.2 * k), (1.7 + 0.1 * k) * std::sin(0.2 * k)});
    for (size_t k = 0; k < points.size(); ++k)
        expected += 0.5 * turn({0, 0}, points[k], points[(k + 1) % points.size()]);
    const Cover cover = coverOf(points, {0, 120});
    EXPECT_NEAR(cover.area, expected, 1e-12 * expected);
    EXPECT_EQ(cover.flipped, 0u);
}

TEST(FaceTriangulation, OverlappingLoopsKeepTheirArea) {
    // Not a polygon with a hole: the "hole" reaches out of the outline. Signed areas still add up.
    const std::vector<PlanePoint> points{{0, 0},     {1, 0},   {1, 1}, {0, 1},
                                         {0.5, 0.5}, {0.5, 2}, {2, 2}, {2, 0.5}};
    EXPECT_NEAR(coverOf(points, {0, 4, 8}).area, 1 - 2.25, 1e-12);
}

}  // namespace
}  // namespace demolish::test
