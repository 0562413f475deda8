// SPDX-License-Identifier: Apache-2.0
// Marched surfaces are closed manifolds of the right shape, and relaxing keeps them on the field.
#include "assets/models/marching.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "assets/models/relax.h"

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;

double sphere(Vec3 p) {
    return length(p) - 1;
}
double torus(Vec3 p) {
    return std::hypot(std::hypot(p.x, p.z) - 1, p.y) - 0.35;
}

double leastQuality(const Surface& surface) {
    double least = 1;
    for (const Triangle& t : surface.triangles) {
        double squares = 0;
        for (int i = 0; i < 3; ++i) {
            const Vec3 side = surface.positions[t[(i + 1) % 3]] - surface.positions[t[i]];
            squares += dot(side, side);
        }
        least = std::min(least, 2 * std::sqrt(3.0) * length(areaNormal(surface, t)) / squares);
    }
    return least;
}

TEST(Marching, SphereIsAClosedManifoldWithItsVolume) {
    // An uneven cell, so that no lattice point is special.
    const Surface surface = marchTetrahedra(sphere, {{-1, -1, -1}, {1, 1, 1}}, 0.0613);
    const Topology topology = topologyOf(surface);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 2);
    EXPECT_EQ(topology.parts, 1);
    EXPECT_NEAR(volumeOf(surface), 4.0 / 3 * kPi, 0.02) << "positive: triangles face outwards";
    EXPECT_GT(surface.triangles.size(), 5000u);
}

TEST(Marching, LatticePointsExactlyOnTheSurfaceDoNoHarm) {
    const Surface surface = marchTetrahedra(
        [](Vec3 p) {
            return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 1;
        },
        {{-1, -1, -1}, {1, 1, 1}}, 0.25);
    EXPECT_TRUE(topologyOf(surface).closed);
    EXPECT_EQ(topologyOf(surface).euler, 2);
    EXPECT_NEAR(volumeOf(surface), 8, 0.6) << "edges are cut off by half a cell at most";
}

TEST(Marching, TorusHasOneHandleAndTwoBallsAreTwoParts) {
    const Topology ring = topologyOf(marchTetrahedra(torus, {{-1.4, -0.4, -1.4}, {1.4, 0.4, 1.4}}, 0.09));
    EXPECT_TRUE(ring.closed);
    EXPECT_EQ(ring.euler, 0);
    const auto balls = [](Vec3 p) { return std::min(length(p) - 1, length(p - Vec3{3, 0, 0}) - 0.5); };
    const Surface both = marchTetrahedra(balls, {{-1, -1, -1}, {3.5, 1, 1}}, 0.11);
    EXPECT_EQ(topologyOf(both).parts, 2);
    EXPECT_EQ(topologyOf(both).euler, 4);
    EXPECT_NEAR(volumeOf(largestPart(both)), 4.0 / 3 * kPi, 0.07);
}

TEST(Marching, RefusesABodyThatLeavesTheGrid) {
    EXPECT_THROW(marchTetrahedra(sphere, {{-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}}, 0.1), std::runtime_error);
}

TEST(Relax, EvensTrianglesOutAndStaysOnTheField) {
    FieldRecipe recipe;
    Part part;
    part.radii = {1, 1.4, 0.8};
    recipe.parts = {part};
    const Field field(recipe);
    Surface surface = marchTetrahedra([&](Vec3 p) { return field.at(p); }, field.bounds(), 0.0713);
    const double before = leastQuality(surface);
    relax(surface, field, 0.0713, 6);
    EXPECT_GT(leastQuality(surface), 3 * before);
    EXPECT_GT(leastQuality(surface), 0.3);
    for (const Vec3 p : surface.positions) ASSERT_NEAR(field.at(p), 0, 1e-4);
}

TEST(Relax, IsTheSameOnOneThreadAndOnMany) {
    const Field field(
        std::get<FieldRecipe>(readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/rabbit.toml").body));
    const auto make = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Surface surface = marchTetrahedra([&](Vec3 p) { return field.at(p); }, field.bounds(), 1.1);
        relax(surface, field, 1.1, 3);
        return surface;
    };
    const Surface one = make(1), many = make(8);
    ASSERT_EQ(one.positions.size(), many.positions.size());
    EXPECT_EQ(one.triangles, many.triangles);
    for (std::size_t i = 0; i < one.positions.size(); ++i) {
        ASSERT_EQ(one.positions[i].x, many.positions[i].x);
        ASSERT_EQ(one.positions[i].y, many.positions[i].y);
        ASSERT_EQ(one.positions[i].z, many.positions[i].z);
    }
}

}  // namespace
}  // namespace demolish::sculptor
