// SPDX-License-Identifier: Apache-2.0
// Weld, doubles, orientation, junctions: triangles that are all there, but not in order.
#include <gtest/gtest.h>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/repair/doubles.h"
#include "sim_cuda/authoring/repair/junctions.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/quad_diagonals.h"
#include "sim_cuda/authoring/repair/weld.h"
#include "tests/unit/repair/open_meshes.h"

namespace demolish {
namespace {

using test::joined;
using test::makeBox;
using test::makeCube;

TEST(Weld, VerticesCloseByBecomeTheFirstOfThem) {
    RepairMesh repair(test::unwelded(makeCube(1)));
    const std::vector<Double3> before = repair.mesh.positions;
    for (size_t v = 1; v < repair.mesh.positions.size(); ++v)
        repair.mesh.positions[v] += Double3{1e-6, -1e-6, 1e-6} * double(v % 3);
    EXPECT_EQ(weldNear(repair, 1e-5), 28u);
    EXPECT_EQ(repair.mesh.positions.size(), 8u);
    EXPECT_EQ(repair.mesh.positions[0].x, before[0].x);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
}

TEST(Weld, FartherThanTheToleranceStaysApart) {
    RepairMesh repair(joined(makeCube(1), makeCube(1), {2e-5, 0, 0}));
    EXPECT_EQ(weldNear(repair, 1e-5), 0u);
    EXPECT_EQ(weldNear(repair, 3e-5), 8u);
}

TEST(Weld, TrianglesThatLoseACornerGoAndCollinearOnesStay) {
    const TriangleMesh mesh = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-7, 0, 0}, {2, 0, 0}},
                                           {{0, 1, 2}, {0, 3, 2}, {0, 1, 4}});
    RepairMesh repair(mesh);
    EXPECT_EQ(weldNear(repair, 1e-5), 1u);
    EXPECT_EQ(repair.source, (std::vector<uint32_t>{0, 2}));
}

TEST(Doubles, OfCopiesWithTheSameSideOutOneStays) {
    RepairMesh repair(joined(makeCube(1), makeCube(1)));
    weldNear(repair, 1e-9);
    const DoubleCounts counts = dropDoubles(repair);
    EXPECT_EQ(counts.same, 12u);
    EXPECT_EQ(repair.size(), 12u);
    EXPECT_EQ(enclosedVolume(repair.mesh), 1);
}

TEST(Doubles, BackToBackWithinSomethingClosedBothGo) {
    RepairMesh repair(joined(makeBox({0, 0, 0}, {1, 1, 1}), makeBox({1, 0, 0}, {1, 1, 1})));
    weldNear(repair, 1e-9);
    EXPECT_EQ(dropDoubles(repair).opposite_both, 2u);
    EXPECT_EQ(repair.size(), 20u);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
    EXPECT_NEAR(enclosedVolume(repair.mesh), 2, 1e-12);
}

TEST(Doubles, OfASheetWithBothSidesOneStays) {
    const TriangleMesh sheet = test::makeSheet(3, 3, 0.1);
    RepairMesh repair(joined(sheet, test::turnedInsideOut(sheet)));
    weldNear(repair, 1e-9);
    EXPECT_EQ(dropDoubles(repair).opposite_one, sheet.triangles.size());
    EXPECT_EQ(repair.size(), sheet.triangles.size());
}

/// As exporters write a surface with both sides: the quads of the second the other way round, each cut from
/// its own first corner.
TriangleMesh withBothSides(const TriangleMesh& quads) {
    TriangleMesh mesh = quads;
    for (size_t t = 0; t < quads.triangles.size(); t += 2) {
        const auto [a, b, c] = quads.triangles[t];
        const uint32_t d = quads.triangles[t + 1][2];
        mesh.triangles.push_back({d, c, b});
        mesh.triangles.push_back({d, b, a});
    }
    mesh.corners.resize(mesh.triangles.size());
    return mesh;
}

/// Quads a b c, a c d, bent a little.
TriangleMesh bentQuads() {
    constexpr uint32_t kAlong = 4;
    std::vector<Double3> positions;
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < kAlong * kAlong; ++i) {
        const double x = 0.1 * (i % kAlong), z = 0.1 * (i / kAlong);
        positions.push_back({x, x * z, z});
    }
    for (uint32_t i = 0; i + 1 < kAlong; ++i)
        for (uint32_t j = 0; j + 1 < kAlong; ++j) {
            const uint32_t a = j * kAlong + i, b = a + kAlong, c = b + 1, d = a + 1;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return test::meshOf(positions, triangles);
}

TEST(QuadDiagonals, OfASheetWithBothSidesOneStays) {
    const TriangleMesh sheet = bentQuads();
    RepairMesh repair(withBothSides(sheet));
    EXPECT_EQ(dropDoubles(repair).opposite_one, 0u) << "the sides are cut differently";
    EXPECT_EQ(alignDiagonals(repair), sheet.triangles.size() / 2);
    EXPECT_EQ(dropDoubles(repair).opposite_one, sheet.triangles.size());
    EXPECT_EQ(repair.mesh.triangles, sheet.triangles);
}

TEST(QuadDiagonals, CornersKeepTheirLooks) {
    TriangleMesh quad =
        withBothSides(test::meshOf({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, {{0, 1, 2}, {0, 2, 3}}));
    for (size_t t = 0; t < 4; ++t)
        for (size_t k = 0; k < 3; ++k) quad.corners[t][k].uv.x = float(10 * (t / 2) + quad.triangles[t][k]);
    RepairMesh repair(quad);
    EXPECT_EQ(alignDiagonals(repair), 1u);
    for (size_t t = 0; t < 4; ++t)
        for (size_t k = 0; k < 3; ++k)
            EXPECT_EQ(repair.mesh.corners[t][k].uv.x, float(10 * (t / 2) + repair.mesh.triangles[t][k]));
}

TEST(QuadDiagonals, SolidsAreLeftAlone) {
    RepairMesh tetrahedron(test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
    EXPECT_EQ(alignDiagonals(tetrahedron), 0u);
    RepairMesh cube(makeCube(1));
    EXPECT_EQ(alignDiagonals(cube), 0u);
}

TEST(Doubles, TheLastOnesAreSettledWithoutOpeningAnEdge) {
    RepairMesh twice(joined(makeCube(1), makeCube(1)));
    weldNear(twice, 1e-9);
    settleDoubles(twice);
    EXPECT_EQ(repeatedTriangleCount(twice.mesh), 0u);
    EXPECT_EQ(openEdgeCount(twice.mesh), 0u);
    EXPECT_NEAR(enclosedVolume(twice.mesh), 2, 1e-12);

    RepairMesh none(joined(makeCube(1), test::turnedInsideOut(makeCube(1))));
    weldNear(none, 1e-9);
    settleDoubles(none);
    EXPECT_EQ(none.size(), 0u);
}

TEST(Orientation, TheLargerAreaKeepsItsDirection) {
    TriangleMesh cube = makeCube(1);
    for (const size_t t : {1u, 4u, 5u, 9u}) std::swap(cube.triangles[t][1], cube.triangles[t][2]);
    RepairMesh repair(std::move(cube));
    const Orientation orientation = orientPatches(repair);
    EXPECT_EQ(orientation.turned, 4u);
    EXPECT_EQ(repair.patches, 1u);
    EXPECT_EQ(repair.parts, 1u);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
    EXPECT_EQ(enclosedVolume(repair.mesh), 1);
}

TEST(Orientation, PartsAreNumbered) {
    RepairMesh repair(joined(makeCube(1), makeCube(1), {5, 0, 0}));
    orientPatches(repair);
    EXPECT_EQ(repair.parts, 2u);
    EXPECT_EQ(repair.part.front(), 0u);
    EXPECT_EQ(repair.part.back(), 1u);
}

/// Two boxes side by side with one wall between them, which belongs to either.
TEST(Junctions, AnInnerWallGoes) {
    RepairMesh repair(joined(makeBox({0, 0, 0}, {1, 1, 1}), makeBox({1, 0, 0}, {1, 1, 1})));
    weldNear(repair, 1e-9);
    std::vector<char> keep(repair.size(), 1);
    for (size_t t = 0; t < 12; ++t)
        if (repair.middle(t).x > 0.49) keep[t] = 0;
    repair.keep(keep);
    ASSERT_EQ(repair.size(), 22u);
    ASSERT_GT(openEdgeCount(repair.mesh), 0u);
    orientPatches(repair);
    const JunctionCounts counts = solveJunctions(repair);
    EXPECT_EQ(counts.edges, 4u);
    EXPECT_EQ(counts.walls, 1u);
    EXPECT_EQ(repair.size(), 20u);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
    EXPECT_NEAR(std::abs(enclosedVolume(repair.mesh)), 2, 1e-12);
}

TEST(Junctions, AFinBecomesAPartOfItsOwn) {
    TriangleMesh cube = makeCube(1);
    const auto edge = cube.triangles[0];
    const Double3 a = cube.positions[edge[0]], b = cube.positions[edge[1]];
    const auto tip = uint32_t(cube.positions.size());
    cube.positions.push_back((a + b) * 1.5);
    cube.triangles.push_back({edge[0], edge[1], tip});
    cube.corners.push_back(cube.corners[0]);
    RepairMesh repair(std::move(cube));
    orientPatches(repair);
    const JunctionCounts counts = solveJunctions(repair);
    EXPECT_EQ(counts.fins, 1u);
    EXPECT_EQ(counts.walls, 0u);
    ASSERT_EQ(repair.parts, 2u);
    EXPECT_NE(repair.part.back(), repair.part.front());
}

}  // namespace
}  // namespace demolish
