// SPDX-License-Identifier: Apache-2.0
// Holes, sides, sheets, parts: what is open becomes closed, and encloses what it should.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/repair/doubles.h"
#include "sim_cuda/authoring/repair/holes.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/outward.h"
#include "sim_cuda/authoring/repair/parts_apart.h"
#include "sim_cuda/authoring/repair/sheets.h"
#include "sim_cuda/authoring/repair/thicken.h"
#include "sim_cuda/authoring/repair/weld.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "sim_cuda/authoring/unused_vertices.h"
#include "tests/unit/repair/open_meshes.h"

namespace demolish {
namespace {

using test::joined;
using test::makeBox;
using test::makeCube;
using test::turnedInsideOut;

RepairMesh oriented(TriangleMesh mesh) {
    RepairMesh repair(std::move(mesh));
    orientPatches(repair);
    return repair;
}

TEST(Holes, ALidIsPutBackAndNothingElseMoves) {
    RepairMesh repair = oriented(test::without(makeCube(1), {2, 3}));
    const auto positions = repair.mesh.positions.size();
    const HoleCounts counts = fillHoles(repair).at(0);
    EXPECT_EQ(counts.holes, 1u);
    EXPECT_EQ(counts.longest, 4u);
    EXPECT_EQ(repair.size(), 12u);
    EXPECT_EQ(repair.mesh.positions.size(), positions);
    EXPECT_EQ(repair.source.back(), kNoSource);
    EXPECT_TRUE(isSolid(repair.mesh));
    EXPECT_NEAR(enclosedVolume(repair.mesh), 1, 1e-12);
}

TEST(Holes, CapsHaveTheLeastArea) {
    // a hole over a dented corner: two ways to cap four edges, one of them half as large
    const TriangleMesh bowl = test::meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {0.5, 0.5, -1}},
                                           {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    RepairMesh repair = oriented(bowl);
    fillHoles(repair);
    double caps = 0;
    for (size_t t = 0; t < repair.size(); ++t)
        if (repair.source[t] == kNoSource) caps += repair.area(t);
    const auto& p = bowl.positions;
    const auto area = [&](int a, int b, int c) {
        return length(cross(p[size_t(b)] - p[size_t(a)], p[size_t(c)] - p[size_t(a)])) / 2;
    };
    EXPECT_NEAR(caps, std::min(area(0, 1, 2) + area(0, 2, 3), area(0, 1, 3) + area(1, 2, 3)), 1e-12);
}

TEST(Holes, LongBordersGetAFan) {
    RepairMesh repair = oriented(test::makeOpenTube(1, 2, 700));
    const HoleCounts counts = fillHoles(repair).at(0);
    EXPECT_EQ(counts.holes, 2u);
    EXPECT_EQ(counts.fans, 2u);
    EXPECT_TRUE(isSolid(repair.mesh));
    EXPECT_NEAR(enclosedVolume(repair.mesh), 2 * std::numbers::pi, 1e-3);
}

TEST(Holes, BordersThatMeetInAVertexAreLoopsOfTheirOwn) {
    // two opposite corners of a 2 x 2 lid are missing: the loops share the middle
    TriangleMesh sheet = test::makeSheet(2, 2, 1);
    RepairMesh repair = oriented(test::without(sheet, {0, 1, 6, 7}));
    const auto borders = borderLoops(repair);
    for (const Border& border : borders)
        EXPECT_EQ(std::set<uint32_t>(border.loop.begin(), border.loop.end()).size(), border.loop.size());
    fillHoles(repair);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
}

TEST(Holes, EveryTriangleOfASoupCloses) {
    // edges of one, two and three faces in no order
    const TriangleMesh soup = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                                           {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 3, 4}, {4, 1, 2}});
    RepairMesh repair = oriented(soup);
    fillHoles(repair);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
    EXPECT_EQ(repeatedTriangleCount(repair.mesh), 0u);
}

OutwardCounts outwardOf(RepairMesh& repair, std::vector<PartFacts>* result = nullptr) {
    const Orientation orientation = orientPatches(repair);
    fillHoles(repair);
    std::vector<PartFacts> facts = factsOfParts(repair, orientation.patch_touched);
    const OutwardCounts counts = turnOutward(repair, facts);
    if (result != nullptr) *result = facts;
    return counts;
}

TEST(Outward, AFileThatIsInsideOutIsTurned) {
    RepairMesh repair(turnedInsideOut(test::without(test::makeSphere(1, 2), {7})));
    EXPECT_EQ(outwardOf(repair).turned, 1u);
    EXPECT_GT(enclosedVolume(repair.mesh), 3.9);
    EXPECT_EQ(openEdgeCount(repair.mesh), 0u);
}

TEST(Outward, HollowsStayAndStrayPartsAreTurned) {
    RepairMesh hollow(joined(makeCube(2), turnedInsideOut(makeCube(1))));
    const OutwardCounts counts = outwardOf(hollow);
    EXPECT_EQ(counts.cavities, 1u);
    EXPECT_EQ(counts.turned, 0u);
    EXPECT_NEAR(enclosedVolume(hollow.mesh), 7, 1e-12);

    RepairMesh apart(joined(makeCube(2), turnedInsideOut(makeCube(1)), {5, 0, 0}));
    EXPECT_EQ(outwardOf(apart).turned, 1u);
    EXPECT_NEAR(enclosedVolume(apart.mesh), 9, 1e-12);

    // the same hollow in a file that is inside out altogether
    RepairMesh both(joined(turnedInsideOut(makeCube(2)), makeCube(1)));
    EXPECT_EQ(outwardOf(both).cavities, 1u);
    EXPECT_NEAR(enclosedVolume(both.mesh), 7, 1e-12);
}

std::vector<PartFacts> sheetsOf(TriangleMesh mesh, RepairMesh& repair) {
    repair = RepairMesh(std::move(mesh));
    std::vector<PartFacts> facts;
    outwardOf(repair, &facts);
    findSheets(repair, facts);
    return facts;
}

TEST(Sheets, FlatAndWideOpenPartsAreSheetsAndHolesAreNot) {
    RepairMesh repair;
    EXPECT_TRUE(sheetsOf(test::makeSheet(4, 4, 1), repair)[0].is_sheet);
    EXPECT_TRUE(sheetsOf(test::makeOpenTube(1, 2, 24), repair)[0].is_sheet);
    EXPECT_FALSE(sheetsOf(test::makeOpenTube(1, 10, 24), repair)[0].is_sheet);  // a rod without its ends
    EXPECT_FALSE(sheetsOf(test::without(makeCube(1), {2, 3}), repair)[0].is_sheet);
    EXPECT_FALSE(sheetsOf(test::without(test::makeSphere(1, 3), {1, 2, 3}), repair)[0].is_sheet);
}

TEST(Sheets, AnEyeInItsSocketIsCapped) {
    // a half sphere with its rim inside of a block
    TriangleMesh sphere = test::makeSphere(1, 3);
    std::set<size_t> lower;
    for (size_t t = 0; t < sphere.triangles.size(); ++t)
        for (const uint32_t v : sphere.triangles[t])
            if (sphere.positions[v].y < 0.5) lower.insert(t);
    const TriangleMesh lens = test::without(sphere, lower);
    RepairMesh repair;
    EXPECT_TRUE(sheetsOf(lens, repair)[0].is_sheet);
    const auto facts = sheetsOf(joined(makeBox({0, -0.5, 0}, {4, 2.5, 4}), lens), repair);
    ASSERT_EQ(facts.size(), 2u);
    EXPECT_FALSE(facts[1].is_sheet);
}

TEST(Sheets, LooseFacesOfABoxEncloseItAndATubeDoesNot) {
    RepairMesh repair(makeCube(1));
    for (size_t t = 0; t < repair.size(); ++t) repair.part[t] = uint32_t(t / 2);
    repair.parts = 6;
    std::vector<PartFacts> facts(6);
    for (PartFacts& part : facts) part.is_sheet = true;
    EXPECT_TRUE(sheetsEncloseSolid(repair, facts));

    facts = sheetsOf(test::makeOpenTube(1, 2, 24), repair);
    EXPECT_FALSE(sheetsEncloseSolid(repair, facts));
    facts = sheetsOf(joined(test::makeSheet(3, 3, 1), test::makeSheet(3, 3, 1), {0, 1, 0}), repair);
    EXPECT_FALSE(sheetsEncloseSolid(repair, facts));
}

TEST(Sheets, TheThicknessSuitsTheParticlesOrIsTheOneAskedFor) {
    RepairMesh repair;
    const auto facts = sheetsOf(test::makeSheet(10, 10, 0.1), repair);
    EXPECT_EQ(sheetThickness(facts, 0.02).at(0), 0.02);
    const double chosen = sheetThickness(facts, 0).at(0), spacing = chosen / 1.5;
    EXPECT_NEAR(chosen * 1 / kSheetParticles, spacing * spacing * spacing, 1e-9);
}

TEST(Thicken, ASheetBecomesAPlateOfAreaTimesThickness) {
    for (const int squares : {1, 5}) {
        RepairMesh repair;
        const auto facts = sheetsOf(test::makeSheet(squares, squares, 1.0 / squares), repair);
        thickenSheets(repair, sheetThickness(facts, 0.05));
        EXPECT_TRUE(isSolid(repair.mesh));
        EXPECT_NEAR(enclosedVolume(repair.mesh), 0.05, 1e-12);
        EXPECT_NEAR(surfaceArea(repair.mesh), 2 + 4 * 0.05, 1e-12);
    }
}

TEST(Thicken, ATubeBecomesAPipe) {
    RepairMesh repair;
    const auto facts = sheetsOf(test::makeOpenTube(1, 2, 64), repair);
    thickenSheets(repair, sheetThickness(facts, 0.1));
    dropUnusedVertices(repair.mesh);
    EXPECT_TRUE(isSolid(repair.mesh));
    EXPECT_NEAR(enclosedVolume(repair.mesh) / (2 * std::numbers::pi * 2 * 0.1), 1, 0.01);
    for (const Double3& p : repair.mesh.positions)
        EXPECT_NEAR(std::abs(std::hypot(p.x, p.z) - 1), 0.05, 1e-3);
}

TEST(Thicken, BothFacesKeepTheirSourceAndLooks) {
    TriangleMesh sheet = test::makeSheet(1, 1, 1);
    sheet.corners[1][2].uv = {0.25f, 0.75f};
    RepairMesh repair;
    const auto facts = sheetsOf(std::move(sheet), repair);
    thickenSheets(repair, sheetThickness(facts, 0.1));
    size_t front = 0, back = 0;
    for (size_t t = 0; t < repair.size(); ++t) {
        if (repair.source[t] != 1) continue;
        ++(repair.normal(t).y > 0 ? front : back);
        const auto& corner = repair.mesh.corners[t][repair.normal(t).y > 0 ? 2 : 1];
        EXPECT_EQ(corner.uv.x, 0.25f);
        EXPECT_EQ(corner.normal.y, repair.normal(t).y > 0 ? 1 : -1);
    }
    EXPECT_EQ(front, 1u);
    EXPECT_EQ(back, 1u);
}

TEST(Parts, WallsBackToBackGoAndThePartsBecomeOne) {
    RepairMesh repair(joined(makeBox({0, 0, 0}, {1, 1, 1}), makeBox({1, 0, 0}, {1, 1, 1})));
    weldNear(repair, 1e-9);
    for (size_t t = 12; t < repair.size(); ++t) repair.part[t] = 1;
    repair.parts = 2;
    glueParts(repair);
    EXPECT_EQ(repair.parts, 1u);
    EXPECT_EQ(repair.size(), 20u);
    EXPECT_TRUE(isSolid(repair.mesh));
}

TEST(Parts, EachGetsVerticesOfItsOwnAndMovesLittle) {
    RepairMesh repair(joined(makeCube(1), makeBox({0, 1, 0}, {1, 1, 1})));
    weldNear(repair, 1e-9);
    for (size_t t = 12; t < repair.size(); ++t) repair.part[t] = 1;
    repair.parts = 2;
    const TriangleMesh before = repair.mesh;
    setPartsApart(repair, 1e-6);
    EXPECT_EQ(repair.mesh.positions.size(), 16u);
    for (size_t t = 0; t < repair.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const double moved = length(repair.at(t, k) - before.positions[before.triangles[t][size_t(k)]]);
            EXPECT_LE(moved, t < 12 ? 0 : 2e-6);
        }
}

}  // namespace
}  // namespace demolish
