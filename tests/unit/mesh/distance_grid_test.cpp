// SPDX-License-Identifier: Apache-2.0
// The distance grid against closed forms, and its independence of the number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

double cubeDistance(const Double3& p, double half) {
    const Double3 q{std::abs(p.x) - half, std::abs(p.y) - half, std::abs(p.z) - half};
    return length(maximum(q, {})) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

TEST(DistanceGrid, Cube) {
    const TriangleMesh mesh = test::makeCube(1);
    const MeshQueries queries(mesh);
    const DistanceGrid grid(mesh, queries);
    const double step = grid.nodeSpacing();
    EXPECT_NEAR(step, 1.0 / 95, 1e-12);
    double worst = 0;
    for (uint64_t i = 0; i < 20000; ++i) {
        const Double3 p = hashRandomInCube(3, 0, i) * 1.2;
        worst = std::max(worst, std::abs(grid.distance(p) - cubeDistance(p, 0.5)));
    }
    EXPECT_LT(
        worst,
        0.87 * step);  // nodes are exact and a distance cannot change faster than 1: half a cell diagonal
    // Away from those it is linear, so trilinear is exact up to float.
    EXPECT_NEAR(grid.distance({0.4, 0.03, -0.1}), -0.1, 1e-6);
    EXPECT_NEAR(grid.distance({0.1, 0.27, 0.02}), -0.23, 1e-6);
    EXPECT_NEAR(grid.distance({0.51, 0.1, 0.2}), 0.01, 1e-6);
    EXPECT_NEAR(grid.distance({3.5, 0.1, 0.2}), 3, 1e-6);  // far outside the grid
    const Double3 g = grid.gradient({0.1, -0.4, 0.2});
    EXPECT_NEAR(g.x, 0, 1e-4);
    EXPECT_NEAR(g.y, -1, 1e-4);
    EXPECT_NEAR(g.z, 0, 1e-4);
}

TEST(DistanceGrid, SphereDistanceAndGradient) {
    const TriangleMesh mesh = test::makeSphere(1, 5);
    const MeshQueries queries(mesh);
    const DistanceGrid grid(mesh, queries);
    const double step = grid.nodeSpacing(), facets = 6e-4;  // the facets lie up to that deep
    double alignment = 0;
    int samples = 0;
    for (uint64_t i = 0; i < 5000; ++i) {
        const Double3 p = hashRandomInCube(5, 0, i) * 2;
        const double r = length(p);
        if (r < 0.2) continue;
        ASSERT_NEAR(grid.distance(p), r - 1, facets + 0.1 * step) << r;
        const Double3 g = grid.gradient(p);
        ASSERT_GT(dot(normalized(g), p * (1 / r)), 0.985)
            << r;  // 10 degrees, worst just beyond the exact band
        alignment += dot(normalized(g), p * (1 / r));
        ++samples;
        ASSERT_NEAR(length(g), 1, 0.15) << r;
    }
    EXPECT_GT(alignment / samples, 0.9997);
    for (uint64_t i = 0; i < 2000; ++i) {  // cells that the surface meets have exact nodes
        const Double3 p = hashRandomInCube(6, 0, i);
        const Double3 out = normalized(p), near = out * (1 + 0.1 * step * (hashRandom(6, 1, i) - 0.5));
        ASSERT_NEAR(grid.distance(near), length(near) - 1, facets + 0.5 * step * step);
        ASSERT_GT(dot(normalized(grid.gradient(near)), out), 0.999);
        ASSERT_NEAR(length(grid.gradient(near)), 1, 0.04);
    }
}

/// Sign and distance at random points agree with the exact queries, on a shape with thin walls.
TEST(DistanceGrid, VaseAgreesWithExactQueries) {
    const TriangleMesh mesh = test::makeVase(50, 30);
    const MeshQueries queries(mesh);
    const DistanceGrid grid(mesh, queries);
    const double step = grid.nodeSpacing();
    for (uint64_t i = 0; i < 5000; ++i) {
        const Double3 r = hashRandomInCube(7, 0, i);
        const Double3 p{r.x * 0.36, 0.252 + r.y * 0.5, r.z * 0.36};
        const double exact = queries.closestPoint(p).distance * (queries.windingNumber(p) > 0 ? -1 : 1);
        ASSERT_NEAR(grid.distance(p), exact, 0.9 * step);
    }
}

TEST(DistanceGrid, InsideNodesAreInsideAndInMortonOrder) {
    const TriangleMesh mesh = test::makeTorus(1, 0.3, 40, 20);
    const MeshQueries queries(mesh);
    const DistanceGrid grid(mesh, queries, 48);
    const auto& nodes = grid.insideNodesInMortonOrder();
    const double cell = std::pow(grid.nodeSpacing(), 3);
    EXPECT_NEAR(double(nodes.size()) * cell / test::signedVolume(mesh), 1, 0.02);
    double jumps = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
        ASSERT_EQ(queries.windingNumber(nodes[i]), 1);
        if (i > 0) jumps += length(nodes[i] - nodes[i - 1]);
    }
    EXPECT_LT(jumps / double(nodes.size()), 3 * grid.nodeSpacing());  // row order would jump across the hole
}

TEST(DistanceGrid, SameBitsForOneAndTwoThreads) {
    const TriangleMesh mesh = test::makeVase(50, 30);
    const MeshQueries queries(mesh);
    const auto make = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return DistanceGrid(mesh, queries, 64);
    };
    const DistanceGrid one = make(1), two = make(2);
    for (uint64_t i = 0; i < 20000; ++i) {
        const Double3 p = hashRandomInCube(9, 0, i) * 0.6 + Double3{0, 0.25, 0};
        ASSERT_EQ(one.distance(p), two.distance(p));
    }
}

}  // namespace
}  // namespace demolish
