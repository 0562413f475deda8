// SPDX-License-Identifier: Apache-2.0
// Seeds in special position: the re-jitter repairs them; hardly disturbed ones need no repair
// (geometry.md 2.5).
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/hash_random.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"

namespace demolish::test {
namespace {

/// n^3 seeds at the centres of equal cubes that fill the unit cube, moved by up to `jitter` (m) along each
/// axis.
std::vector<Double3> lattice(int n, double jitter) {
    std::vector<Double3> seeds;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                seeds.push_back(Double3{(x + 0.5) / n - 0.5, (y + 0.5) / n - 0.5, (z + 0.5) / n - 0.5} +
                                hashRandomInCube(3, 1, seeds.size()) * (2 * jitter));
    return seeds;
}

void expectEqualCubes(const CellComplex& complex, int n) {
    EXPECT_EQ(countOpenCells(complex), 0u);
    EXPECT_TRUE(complex.open_cells.empty());
    const std::vector<double> volumes = loopVolumes(complex);
    for (const double volume : volumes) ASSERT_NEAR(volume * n * n * n, 1, 1e-4);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-9);
    EXPECT_NEAR(exteriorArea(complex), 6, 1e-8);
}

TEST(DegenerateSeeds, ExactLatticeIsRepaired) {
    const QueriedMesh& cube = *testBody("cube");
    for (const int n : {2, 4, 9, 12}) {
        SCOPED_TRACE(n);
        const CellComplex complex = buildCellComplex(cube.mesh, cube.queries, lattice(n, 0), 1.0 / n, 1);
        EXPECT_GT(complex.rejitter_rounds, 0u);
        expectEqualCubes(complex, n);
        const std::vector<Double3> exact = lattice(n, 0);
        for (size_t i = 0; i < exact.size(); ++i)
            ASSERT_LT(length(complex.seeds[i] - exact[i]), 3 * 2e-6 / n);
    }
}

TEST(DegenerateSeeds, HardlyDisturbedLatticeNeedsNoRepair) {
    const QueriedMesh& cube = *testBody("cube");
    for (const int n : {4, 10, 17}) {
        SCOPED_TRACE(n);
        const CellComplex complex =
            buildCellComplex(cube.mesh, cube.queries, lattice(n, 1e-7 / n), 1.0 / n, 1);
        EXPECT_EQ(complex.rejitter_rounds, 0u);
        expectEqualCubes(complex, n);
    }
}

TEST(DegenerateSeeds, BisectorsInMeshFacesNeedNoRepair) {
    // Every other layer of seeds lies outside the cube, whose faces then are bisectors but for the jitter.
    const QueriedMesh& cube = *testBody("cube");
    std::vector<Double3> seeds = lattice(6, 1e-7 / 6);
    for (Double3& p : seeds) p = p * 1.5;
    const CellComplex complex = buildCellComplex(cube.mesh, cube.queries, seeds, 1.5 / 6, 1);
    EXPECT_EQ(countOpenCells(complex), 0u);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-9);
}

TEST(DegenerateSeeds, SeedsOfOnePlaneAreEnough) {
    const QueriedMesh& cube = *testBody("cube");
    std::vector<Double3> seeds;
    for (uint64_t i = 0; i < 40; ++i) {
        seeds.push_back(hashRandomInCube(5, 1, i));
        seeds.back().y *= 1e-7;
    }
    const CellComplex complex = buildCellComplex(cube.mesh, cube.queries, seeds, std::cbrt(1.0 / 40), 1);
    EXPECT_EQ(countOpenCells(complex), 0u);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-9);
}

TEST(DegenerateSeeds, CoincidingSeedsAreMovedApart) {
    const QueriedMesh& torus = *testBody("torus");
    std::vector<Double3> seeds = randomSeeds(torus.mesh, torus.queries, 300, 5);
    seeds[17] = seeds[203];
    seeds[299] = seeds[1];
    const CellComplex complex =
        buildCellComplex(torus.mesh, torus.queries, seeds, spacingOf(torus.mesh, 300), 1);
    EXPECT_GT(complex.rejitter_rounds, 0u);
    EXPECT_EQ(countOpenCells(complex), 0u);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_GT(std::min(volumes[17], volumes[203]), 0);
}

TEST(DegenerateSeeds, FacesOnEachOtherWithinTheSolidNeedNoRepair) {
    TriangleMesh mesh = testBody("cube")->mesh;
    const auto first = uint32_t(mesh.positions.size());
    for (const Double3& p : {Double3{-0.41, -0.37, -0.43}, {0.43, 0.31, -0.2}, {0.11, 0.42, 0.39}})
        mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 1});
    mesh.corners.resize(mesh.triangles.size());
    const QueriedMesh folded(std::move(mesh));
    const CellComplex complex =
        buildCellComplex(folded.mesh, folded.queries, randomSeeds(folded.mesh, folded.queries, 300, 5),
                         spacingOf(folded.mesh, 300), 1);
    EXPECT_EQ(complex.rejitter_rounds, 0u);
    EXPECT_EQ(countOpenCells(complex), 0u);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-9);
}

TEST(DegenerateSeeds, MeshWithAHoleEndsWithItsOpenCellsNamed) {
    TriangleMesh mesh = testBody("torus")->mesh;
    mesh.triangles.pop_back();
    mesh.corners.pop_back();
    const QueriedMesh open(std::move(mesh));
    const std::vector<Double3> seeds =
        randomSeeds(testBody("torus")->mesh, testBody("torus")->queries, 200, 5);
    const CellComplex complex =
        buildCellComplex(open.mesh, open.queries, seeds, spacingOf(open.mesh, 200), 1);
    EXPECT_EQ(complex.rejitter_rounds, 3u);
    EXPECT_GT(complex.open_cells.size(), 0u);
    EXPECT_LT(complex.open_cells.size(), 20u);
    EXPECT_EQ(complex.open_cells.size(), countOpenCells(complex));
}

}  // namespace
}  // namespace demolish::test
