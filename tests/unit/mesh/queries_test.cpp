// SPDX-License-Identifier: Apache-2.0
// Winding number and closest point against closed forms and brute force.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/point_triangle.h"
#include "sim_cuda/authoring/triangle_tree.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

/// Independent of any ray: sum of solid angles (Van Oosterom and Strackee 1983) over 4 pi.
int windingBySolidAngle(const TriangleMesh& mesh, const Double3& p) {
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Double3 a = mesh.positions[t[0]] - p, b = mesh.positions[t[1]] - p,
                      c = mesh.positions[t[2]] - p;
        const double la = length(a), lb = length(b), lc = length(c);
        sum += 2 * std::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return int(std::lround(sum / (4 * std::numbers::pi)));
}

/// Random points in a box of the given half sizes.
Double3 randomPoint(uint64_t counter, const Double3& half) {
    const Double3 r = hashRandomInCube(11, 0, counter) * 2;
    return {r.x * half.x, r.y * half.y, r.z * half.z};
}

void expectWindingOfSolidAngle(const TriangleMesh& mesh, const Double3& half, const Double3& middle = {}) {
    const MeshQueries queries(mesh);
    int inside = 0;
    for (uint64_t i = 0; i < 400; ++i) {
        const Double3 p = middle + randomPoint(i, half);
        const int expected = windingBySolidAngle(mesh, p);
        inside += expected != 0;
        ASSERT_EQ(queries.windingNumber(p), expected) << p.x << ' ' << p.y << ' ' << p.z;
    }
    EXPECT_GT(inside, 10);  // otherwise nothing was tested
}

TEST(Winding, CubeTorusSphereVase) {
    expectWindingOfSolidAngle(test::makeCube(1), {0.7, 0.7, 0.7});
    expectWindingOfSolidAngle(test::makeTorus(1, 0.3, 40, 20), {1.4, 0.35, 1.4});
    expectWindingOfSolidAngle(test::makeSphere(1, 3), {1.1, 1.1, 1.1});
    expectWindingOfSolidAngle(test::makeVase(50, 30), {0.18, 0.26, 0.18}, {0, 0.25, 0});
}

TEST(Winding, ShellsCountUp) {
    const TriangleMesh outer = test::makeSphere(1, 2), inner = test::makeCube(0.6);
    const MeshQueries overlap(test::joined(outer, inner)),
        hollow(test::joined(outer, test::turnedInsideOut(inner)));
    const MeshQueries inverted(test::turnedInsideOut(outer));
    EXPECT_EQ(overlap.windingNumber({0.1, 0, 0}), 2);
    EXPECT_EQ(overlap.windingNumber({0.7, 0, 0}), 1);
    EXPECT_EQ(hollow.windingNumber({0.1, 0, 0}), 0);
    EXPECT_EQ(hollow.windingNumber({0.7, 0, 0}), 1);
    EXPECT_EQ(inverted.windingNumber({0, 0, 0}), -1);
    EXPECT_EQ(inverted.windingNumber({0, 2, 0}), 0);
}

/// From inside a cube towards its corners, edges and diagonals, and on lines through a sphere's vertices:
/// places where a careless ray counts an edge twice or not at all.
TEST(Winding, PointsInLineWithVerticesAndEdges) {
    const MeshQueries cube(test::makeCube(2));
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int z = -3; z <= 3; ++z) {
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 2) continue;  // on the surface
                const int expected = std::abs(x) < 2 && std::abs(y) < 2 && std::abs(z) < 2;
                ASSERT_EQ(cube.windingNumber({x * 0.5, y * 0.5, z * 0.5}), expected)
                    << x << ' ' << y << ' ' << z;
            }
    const TriangleMesh mesh = test::makeSphere(1, 3);
    const MeshQueries sphere(mesh);
    for (const Double3& v : mesh.positions) {
        ASSERT_EQ(sphere.windingNumber(v * 0.5), 1);
        ASSERT_EQ(sphere.windingNumber(v * 0.9999999), 1);
        ASSERT_EQ(sphere.windingNumber(v * 1.0000001), 0);
    }
}

/// The first ray's direction is fixed, so vertices and edges can be laid exactly in its way.
TEST(Winding, RayThroughVertexAndEdgeIsDrawnAgain) {
    const Double3 ray{0.2837461, 0.1592653, 0.9455823};
    for (const Double3& aim : {Double3{0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, 0.1, 0.5}, {0.2, 0.2, 0.5}}) {
        const MeshQueries cube(test::makeCube(1));
        for (int step = 1; step <= 8; ++step) {
            const Double3 p = aim - ray * (step * 0.125);
            const double outside = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.5;
            if (std::abs(outside) < 1e-9) continue;
            EXPECT_EQ(cube.windingNumber(p), outside < 0) << step;
        }
    }
}

TEST(Winding, FarAndThin) {
    TriangleMesh plate = test::makeCube(1);
    for (Double3& p : plate.positions) p = Double3{p.x + 1000, p.y * 1e-7, p.z};
    const MeshQueries queries(plate);
    EXPECT_EQ(queries.windingNumber({1000.2, 0.2e-7, 0.1}), 1);
    EXPECT_EQ(queries.windingNumber({1000.2, 0.6e-7, 0.1}), 0);
    EXPECT_EQ(queries.windingNumber({-1000, 0, 0}), 0);
    EXPECT_EQ(queries.windingNumber({1e12, 1e12, 1e12}), 0);
}

void expectClosestOfBruteForce(const TriangleMesh& mesh, const Double3& half) {
    const MeshQueries queries(mesh);
    for (uint64_t i = 0; i < 500; ++i) {
        const Double3 p = randomPoint(i, half);
        double best = 1e300;
        for (const auto& t : mesh.triangles) {
            const Double3 q =
                closestOnTriangle(p, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
            best = std::min(best, length(p - q));
        }
        const ClosestPoint found = queries.closestPoint(p);
        ASSERT_DOUBLE_EQ(found.distance, best);
        ASSERT_NEAR(length(p - found.point), best, 1e-14);
        const auto& t = mesh.triangles[found.triangle];
        const Double3 on =
            closestOnTriangle(found.point, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
        ASSERT_LT(length(on - found.point), 1e-14);
        EXPECT_EQ(queries.closestPoint(p, best * 1.001).triangle, found.triangle);
        EXPECT_EQ(queries.closestPoint(p, best * 0.999).triangle, kNoTriangle);
    }
}

TEST(ClosestPoint, AgreesWithBruteForce) {
    expectClosestOfBruteForce(test::makeTorus(1, 0.3, 30, 14), {1.6, 0.8, 1.6});
}

/// Slender, askew, through each other: boxes that are mostly empty.
TriangleMesh askewBeams(int count) {
    TriangleMesh beams;
    for (int i = 0; i < count; ++i) {
        const Double3 along = normalized(hashRandomInCube(12, 0, uint64_t(i)) + Double3{0.5, 0.5, 0.5}),
                      side = normalized(cross(along, {0.3, -0.8, 0.1})), up = cross(along, side),
                      middle = hashRandomInCube(12, 1, uint64_t(i));
        TriangleMesh beam = test::makeCube(1);
        for (Double3& p : beam.positions) p = middle + along * (4 * p.x) + (side * p.y + up * p.z) * 0.1;
        beams = i == 0 ? beam : test::joined(beams, beam);
    }
    return beams;
}

/// The tree has such triangles in several leaves; the answers are those of each once.
TEST(SlenderTriangles, AreHalvedInTheTreeAndCountOnce) {
    const TriangleMesh beams = askewBeams(40);
    EXPECT_TRUE(MeshQueries(beams).tree().repeats());
    EXPECT_FALSE(MeshQueries(test::makeTorus(1, 0.3, 30, 14)).tree().repeats());
    EXPECT_FALSE(MeshQueries(test::makeCube(1)).tree().repeats());
    expectWindingOfSolidAngle(beams, {0.6, 0.6, 0.6});
    expectClosestOfBruteForce(beams, {1.5, 1.5, 1.5});
}

/// Of triangles whose plane rounding decides, none is passed over.
TEST(ClosestPoint, OfNeedlesAgreesWithBruteForce) {
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-13, 0.0}) {
        SCOPED_TRACE(width);
        TriangleMesh needles;
        for (uint64_t i = 0; i < 300; ++i) {
            const Double3 from = hashRandomInCube(13, 0, i), way = hashRandomInCube(13, 1, i);
            const auto first = uint32_t(needles.positions.size());
            for (const Double3& p : {from, from + way, from + way * 0.4 + hashRandomInCube(13, 2, i) * width})
                needles.positions.push_back(p);
            needles.triangles.push_back({first, first + 1, first + 2});
        }
        const MeshQueries queries(needles);
        for (uint64_t i = 0; i < 500; ++i) {
            const Double3 p = randomPoint(i, {1.2, 1.2, 1.2});
            double best = 1e300;
            for (const auto& [a, b, c] : needles.triangles)
                best =
                    std::min(best, length(p - closestOnTriangle(p, needles.positions[a], needles.positions[b],
                                                                needles.positions[c])));
            ASSERT_DOUBLE_EQ(queries.closestPoint(p).distance, best);
        }
    }
}

TEST(ClosestPoint, OfNoTrianglesIsNone) {
    const MeshQueries queries(TriangleMesh{});
    EXPECT_EQ(queries.closestPoint({1, 2, 3}).triangle, kNoTriangle);
    EXPECT_EQ(queries.windingNumber({}), 0);
}

/// Large trees are built at several places at the same time.
TEST(ClosestPoint, OfManyTrianglesAgreesWithBruteForce) {
    expectClosestOfBruteForce(test::makeTorus(1, 0.3, 400, 100), {1.5, 0.5, 1.5});
}

/// The area of their boxes is no number any more.
TEST(SlenderTriangles, OfHugeMeshesAreNotHalvedWithoutEnd) {
    TriangleMesh mesh = test::makeSphere(1, 2);
    for (Double3& p : mesh.positions) p = p * 1e200;
    EXPECT_FALSE(TriangleTree(mesh).repeats());
    for (Double3& p : mesh.positions) p = p * 1e-200 * 1e-200;
    EXPECT_FALSE(TriangleTree(mesh).repeats());
}

/// A part's own crossings sum up to its own winding number, whatever else the ray passes.
TEST(Crossings, OfEachPartSumUpToItsWindingNumber) {
    constexpr int kBeams = 40;
    const TriangleMesh beams = askewBeams(kBeams);
    const size_t of_a_beam = beams.triangles.size() / kBeams;
    const MeshQueries all(beams);
    int inside = 0;
    for (int i = 0; i < kBeams; ++i) {
        TriangleMesh beam = beams;
        beam.triangles.assign(beams.triangles.begin() + std::ptrdiff_t(size_t(i) * of_a_beam),
                              beams.triangles.begin() + std::ptrdiff_t(size_t(i + 1) * of_a_beam));
        const Double3 middle = hashRandomInCube(12, 1, uint64_t(i));
        for (uint64_t k = 0; k < 20; ++k) {
            const Double3 p = middle + randomPoint(k, {0.08, 0.08, 0.08});
            int sum = 0;
            for (const SurfaceCrossing& crossing : all.crossings(p))
                if (crossing.triangle / of_a_beam == size_t(i)) sum += crossing.direction;
            ASSERT_EQ(sum, windingBySolidAngle(beam, p));
            inside += sum;
        }
    }
    EXPECT_GT(inside, 50);
}

/// Seven regions of a triangle (three corners, three edges, the inside), and triangles without area.
TEST(ClosestPoint, RegionsOfATriangle) {
    const Double3 a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0};
    const auto expect = [&](const Double3& p, const Double3& q) {
        for (const Double3& found :
             {closestOnTriangle(p, a, b, c), closestOnTriangle(p, c, b, a), closestOnTriangle(p, b, c, a)})
            EXPECT_LT(length(found - q), 1e-15) << p.x << ' ' << p.y << ' ' << p.z;
    };
    expect({0.5, 0.5, 3}, {0.5, 0.5, 0});
    expect({-1, -1, 1}, a);
    expect({4, -1, 1}, b);
    expect({-1, 5, -1}, c);
    expect({0.7, -2, 1}, {0.7, 0, 0});
    expect({-2, 0.7, 1}, {0, 0.7, 0});
    expect({2, 2, 1}, {1, 1, 0});
    const Double3 middle = closestOnTriangle({1, 1, 0}, a, b, {1, 0, 0});
    EXPECT_LT(length(middle - Double3{1, 0, 0}), 1e-15);
    EXPECT_LT(length(closestOnTriangle({1, 1, 0}, a, a, a) - a), 1e-15);
}

}  // namespace
}  // namespace demolish
