// SPDX-License-Identifier: Apache-2.0
// The chain: which steps a mesh goes through, and what comes out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/repair/quad_diagonals.h"
#include "sim_cuda/authoring/repair/repair.h"
#include "sim_cuda/authoring/repair/weld.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/repair/open_meshes.h"

namespace demolish {
namespace {

using test::joined;
using test::makeBox;
using test::makeCube;
using ::testing::HasSubstr;

RepairedMesh repairedIn(RepairMode mode, const TriangleMesh& mesh) {
    return repairMesh(mesh, {.mode = mode});
}
RepairedMesh repaired(const TriangleMesh& mesh) {
    return repairedIn(RepairMode::kAuto, mesh);
}

bool sameBits(const TriangleMesh& a, const TriangleMesh& b) {
    const auto same = [](const Double3& p, const Double3& q) {
        return p.x == q.x && p.y == q.y && p.z == q.z;
    };
    return a.triangles == b.triangles &&
           std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end(), same);
}

TEST(Repair, ClosedMeshesPassUntouched) {
    const TriangleMesh hollow = joined(makeCube(2), test::turnedInsideOut(makeCube(1)));
    for (const TriangleMesh& mesh : {makeCube(1), test::makeTorus(1, 0.3, 24, 12), test::makeVase(20, 20),
                                     hollow, joined(makeCube(1), makeCube(1), {3, 0, 0})})
        for (const RepairMode mode : {RepairMode::kAuto, RepairMode::kExact, RepairMode::kOff}) {
            const RepairedMesh result = repairedIn(mode, mesh);
            EXPECT_TRUE(result.report.untouched);
            EXPECT_TRUE(sameBits(result.mesh, mesh));
            EXPECT_TRUE(result.source.empty());
            EXPECT_EQ(repairSentence(result.report), "");
        }
}

TEST(Repair, HolesAreFilledAndNoVertexMoves) {
    const TriangleMesh sphere = test::makeSphere(1, 3);
    const RepairedMesh result = repaired(test::without(sphere, {10, 11, 400}));
    ASSERT_TRUE(isSolid(result.mesh));
    EXPECT_TRUE(sameBits({{}, result.mesh.positions, {}, {}}, {{}, sphere.positions, {}, {}}));
    EXPECT_EQ(result.mesh.triangles.size(), sphere.triangles.size());
    EXPECT_EQ(result.report.remeshed, RemeshCause::kNone);
    EXPECT_EQ(result.report.open_edges, 7u);
    EXPECT_EQ(result.report.holes, 2u);
    EXPECT_EQ(repairSentence(result.report), "2 holes filled (the longest of 4 edges)");
}

TEST(Repair, WeldingIsEnoughForLooseFaces) {
    const RepairedMesh result = repaired(test::unwelded(makeCube(1)));
    ASSERT_TRUE(isSolid(result.mesh));
    EXPECT_EQ(result.report.welded, 28u);
    EXPECT_EQ(result.report.parts, 1u);
    EXPECT_EQ(enclosedVolume(result.mesh), 1);
    for (uint32_t t = 0; t < 12; ++t) EXPECT_EQ(result.source[t], t);
}

TEST(Repair, InsideOutDoubledAndMixedDirections) {
    const RepairedMesh inverted = repaired(test::turnedInsideOut(makeCube(1)));
    EXPECT_EQ(enclosedVolume(inverted.mesh), 1);
    EXPECT_THAT(repairSentence(inverted.report), HasSubstr("1 part turned outside out"));

    RepairMesh twice(joined(makeCube(1), makeCube(1)));
    weldNear(twice, 1e-9);  // as an import does
    const RepairedMesh once = repaired(twice.mesh);
    EXPECT_EQ(once.mesh.triangles.size(), 12u);

    TriangleMesh mixed = test::makeTorus(1, 0.3, 16, 8);
    for (size_t t = 0; t < mixed.triangles.size(); t += 3)
        std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
    EXPECT_NEAR(enclosedVolume(repaired(mixed).mesh), enclosedVolume(test::makeTorus(1, 0.3, 16, 8)), 1e-12);
}

TEST(Repair, SheetsAreThickened) {
    const RepairedMesh plate = repairMesh(test::makeSheet(2, 2, 0.5), {.thickness = 0.04});
    ASSERT_TRUE(isSolid(plate.mesh));
    EXPECT_NEAR(enclosedVolume(plate.mesh), 0.04, 1e-12);
    EXPECT_EQ(repairSentence(plate.report), "1 sheet made 0.04 m thick");
    const RepairedMesh pipe = repairMesh(test::makeOpenTube(1, 2, 48), {.thickness = 0.1});
    EXPECT_NEAR(enclosedVolume(pipe.mesh) / (0.4 * std::numbers::pi), 1, 0.01);
}

/// A leaf as games have it: quads that are there a second time, turned, and cut the other way.
TriangleMesh leafWithBothSides(double bend) {
    TriangleMesh leaf;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) leaf.positions.push_back({0.1 * i, bend * i * j, 0.1 * j});
    for (uint32_t i = 0; i < 2; ++i)
        for (uint32_t j = 0; j < 2; ++j) {
            const uint32_t a = 3 * i + j, b = a + 1, c = a + 4, d = a + 3;
            for (const auto& t : {Triangle{a, b, c}, {a, c, d}, {d, c, b}, {d, b, a}})
                leaf.triangles.push_back(t);
        }
    leaf.corners.resize(leaf.triangles.size());
    return leaf;
}

TEST(Repair, ASheetWithBothSidesIsOnePlate) {
    const RepairedMesh plate = repairMesh(leafWithBothSides(0), {.thickness = 0.01});
    ASSERT_TRUE(isSolid(plate.mesh));
    EXPECT_NEAR(enclosedVolume(plate.mesh), 0.2 * 0.2 * 0.01, 1e-12);
    EXPECT_EQ(repairSentence(plate.report), "8 doubled triangles dropped; 1 sheet made 0.01 m thick");
    for (const double bend : {0.005, -0.005}) {  // of which one encloses a little, and one less than nothing
        const TriangleMesh leaf = leafWithBothSides(bend);
        EXPECT_NEAR(enclosedVolume(repairMesh(leaf, {.thickness = 0.01}).mesh), 0.2 * 0.2 * 0.01, 3e-5);
        const TriangleMesh with_ball = joined(leaf, test::makeSphere(1, 2), {3, 0, 0});
        EXPECT_EQ(repairMesh(with_ball, {.thickness = 0.01}).report.sheets, 1u);
    }
}

/// Two cubes wall to wall with vertices in common, as a half and its mirror image: closed, and bodies both.
TEST(Repair, BodiesThatShareASideCutTwoWaysPassUntouched) {
    TriangleMesh other = makeCube(1);
    other.triangles[0] = {0, 4, 2};  // of the side towards the first cube
    other.triangles[1] = {4, 6, 2};
    RepairMesh welded(joined(makeCube(1), other, {1, 0, 0}));
    weldNear(welded, 1e-9);
    const TriangleMesh cubes_and_ball = joined(welded.mesh, test::makeSphere(0.2, 2), {5, 0, 0});
    EXPECT_TRUE(repaired(welded.mesh).report.untouched);
    EXPECT_TRUE(repaired(cubes_and_ball).report.untouched);
    EXPECT_TRUE(sameBits(repaired(cubes_and_ball).mesh, cubes_and_ball));
    EXPECT_EQ(alignDiagonals(welded), 1u) << "or this tests nothing";
}

/// As a mirror that lies in a cube's own middle makes it: closed, but with nothing in it.
TEST(Repair, ACubeAndItsInsideOutAreOneCube) {
    TriangleMesh twice = makeCube(1);
    for (size_t t = 0; t < 12; t += 2) {
        const auto [a, b, c] = twice.triangles[t];
        const uint32_t d = twice.triangles[t + 1][2];
        twice.triangles.push_back({d, c, b});
        twice.triangles.push_back({d, b, a});
    }
    twice.corners.resize(24);
    const TriangleMesh ball = test::makeSphere(1, 2);
    const RepairedMesh both = repaired(joined(twice, ball, {3, 0, 0}));
    EXPECT_NEAR(enclosedVolume(both.mesh), 1 + enclosedVolume(ball), 1e-9);
    EXPECT_EQ(repairSentence(both.report), "12 doubled triangles dropped");
}

TEST(Repair, AThinRingWithAHoleIsARing) {
    const double radius = 0.006;
    const TriangleMesh ring = test::makeTorus(1, radius, 64, 8);
    const RepairedMesh closed = repairMesh(test::without(ring, {5}), {.mode = RepairMode::kExact});
    ASSERT_TRUE(isSolid(closed.mesh));
    EXPECT_NEAR(enclosedVolume(closed.mesh), enclosedVolume(ring), 1e-9);
    EXPECT_EQ(repairSentence(closed.report), "1 hole filled (the longest of 3 edges)");
}

/// A cloud as games have it: eight upright planes, one behind the other. The winding number takes the air
/// between them for a solid.
TEST(Repair, PlanesInARowAreThickenedWhereTheyEncloseNothing) {
    const double middle_and_half[8][5] = {{0.07, 0.46, 0.07, 0.5, 0.4},   {-0.02, 0.75, -0.04, 0.17, 0.24},
                                          {0.01, 0.12, 0.05, 0.16, 0.37}, {-0.06, 0.1, 0.03, 0.13, 0.4},
                                          {0, 0.32, 0.05, 0.2, 0.14},     {-0.07, 0.64, 0.01, 0.17, 0.14},
                                          {-0.02, 0.1, 0.05, 0.1, 0.32},  {-0.11, 0.08, -0.18, 0.12, 0.1}};
    std::vector<Double3> positions;
    std::vector<Triangle> triangles;
    double area = 0;
    for (const auto& [x, y, z, high, wide] : middle_and_half) {
        const auto first = static_cast<uint32_t>(positions.size());
        for (const auto& [up, aside] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}})
            positions.push_back({x, y + up * high, z + aside * wide});
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
        area += 4 * high * wide;
    }
    const RepairedMesh result = repairMesh(test::meshOf(positions, triangles), {.thickness = 0.005});
    ASSERT_TRUE(isSolid(result.mesh));
    EXPECT_EQ(result.report.sheets, 8u);
    EXPECT_NEAR(enclosedVolume(result.mesh), 0.005 * area, 1e-9);
}

TEST(Repair, PartsThatOverlapCountOnce) {
    const TriangleMesh bars = joined(makeBox({}, {2, 0.6, 0.6}), makeBox({}, {0.6, 0.6, 2}));
    const RepairedMesh result = repaired(bars);
    ASSERT_TRUE(isSolid(result.mesh));
    EXPECT_NEAR(enclosedVolume(result.mesh) / (2 * 0.72 - 0.216), 1, 0.01);
    EXPECT_EQ(result.report.united, 2u);
    EXPECT_NEAR(result.report.overlap, 0.216 / 1.224, 0.02);
    const RepairedMesh exact = repairedIn(RepairMode::kExact, bars);
    EXPECT_TRUE(sameBits(exact.mesh, bars));
    EXPECT_GT(exact.report.overlap, 0.1);
}

TEST(Repair, TheSameMeshForOneAndTwoThreads) {
    const TriangleMesh bars = joined(makeBox({}, {2, 0.6, 0.6}), makeBox({}, {0.6, 0.6, 2}));
    const auto make = [](const TriangleMesh& mesh, RepairMode mode, size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return repairedIn(mode, mesh).mesh;
    };
    EXPECT_TRUE(sameBits(make(bars, RepairMode::kAuto, 1), make(bars, RepairMode::kAuto, 2)));
    const TriangleMesh open = test::without(test::makeSphere(1, 3), {1, 2, 3});
    EXPECT_TRUE(sameBits(make(open, RepairMode::kRemesh, 1), make(open, RepairMode::kRemesh, 2)));
}

TEST(Repair, ModesAllowAndForbid) {
    const TriangleMesh open = test::without(makeCube(1), {0});
    EXPECT_FALSE(isSolid(repairedIn(RepairMode::kOff, open).mesh));
    EXPECT_EQ(repairedIn(RepairMode::kExact, open).mesh.triangles.size(), 12u);
    const RepairedMesh anew = repairedIn(RepairMode::kRemesh, makeCube(1));
    EXPECT_EQ(anew.report.remeshed, RemeshCause::kAsked);
    EXPECT_GT(anew.mesh.triangles.size(), 1000u);
    EXPECT_NEAR(enclosedVolume(anew.mesh), 1, 1e-3);
}

/// Whatever it is, it is closed afterwards, or says so; never a crash.
TEST(Repair, NothingIsTooBroken) {
    std::vector<TriangleMesh> meshes(2);
    meshes.push_back(test::meshOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));  // collinear
    meshes.push_back(test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}, {0, 2, 1}}));
    meshes.push_back(test::meshOf({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}));  // a point
    uint64_t state = 7;
    const auto dice = [&](uint64_t faces) {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return (state >> 33) % faces;
    };
    for (int soup = 0; soup < 20; ++soup) {
        std::vector<Double3> positions;
        std::vector<Triangle> triangles;
        for (int v = 0; v < 12; ++v) positions.push_back({double(dice(5)), double(dice(5)), double(dice(5))});
        for (int t = 0; t < 30; ++t) {
            const Triangle triangle{uint32_t(dice(12)), uint32_t(dice(12)), uint32_t(dice(12))};
            if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
                triangles.push_back(triangle);
        }
        meshes.push_back(test::meshOf(positions, triangles));
    }
    for (size_t i = 0; i < meshes.size(); ++i) {
        SCOPED_TRACE(i);
        const RepairedMesh result = repaired(meshes[i]);
        EXPECT_TRUE(isSolid(result.mesh) || i < 5) << repairSentence(result.report);
        EXPECT_EQ(result.mesh.corners.size(), result.mesh.triangles.size());
        EXPECT_TRUE(result.source.empty() || result.source.size() == result.mesh.triangles.size());
    }
}

TEST(RepairedSolid, AFlatSheetIsScaledByItsLongestSideAndAsThickAsAskedFor) {
    MeshPlacement placement{.height = 3};
    placement.repair.thickness = 0.2;
    const auto solid = makeSolidMesh(test::makeSheet(4, 2, 7), "sheet.obj", placement);
    const SolidMeshInfo& info = meshInfo(*solid);
    EXPECT_NEAR(info.bounds_max.x - info.bounds_min.x, 3, 1e-9);
    EXPECT_NEAR(info.bounds_max.y, 0.2, 1e-9);
    EXPECT_EQ(info.bounds_min.y, 0);
    EXPECT_NEAR(repairReport(*solid).thickness, 0.2, 1e-12);
}

/// A sphere in a tangle: two lobes of opposite winding, closed and of positive volume.
TEST(RepairedSolid, CellsWithoutVolumeAskForANewSurface) {
    const TriangleMesh mesh =
        joined(test::makeSphere(1, 3), test::turnedInsideOut(test::makeSphere(0.6, 3)), {1.2, 0, 0});
    MeshPlacement exact{};
    exact.repair.mode = RepairMode::kExact;
    EXPECT_THROW(fillWithParticles(*makeSolidMesh(mesh, "lobes.obj", exact), {.particles = 200}),
                 InputFileError);
    // put together at one vertex, so that it counts as one part and is not looked through before
    const auto solid =
        std::make_shared<const SolidMesh>(RepairedMesh{mesh, {}, {}}, RepairMode::kAuto, nullptr);
    const auto body = fillWithParticles(*solid, {.particles = 200});
    EXPECT_TRUE(body->remeshed);
    EXPECT_EQ(body->open_cells, 0u);
    for (const Particle& particle : body->particles) EXPECT_GT(particle.volume, 0);
}

}  // namespace
}  // namespace demolish
