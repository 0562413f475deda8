// SPDX-License-Identifier: Apache-2.0
// Parts of a cell that the shape of the solid cuts off from it go to a neighbour (geometry.md 2.6); volumes
// follow from the bisectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

const Double3 kHigh{0.5, 5, 0}, kMiddle{0.5, 3, 0}, kBase{1.5, 0.5, 0};

CellComplex cut(const QueriedMesh& body, const std::vector<Double3>& seeds) {
    return buildCellComplex(body.mesh, body.queries, seeds, spacingOf(body.mesh, seeds.size()), 1);
}

void expectWhole(const CellComplex& complex, const QueriedMesh& body) {
    EXPECT_EQ(countOpenCells(complex), 0u);
    EXPECT_EQ(countCutOffParts(complex), 0u);
    EXPECT_TRUE(triangulationsFitLoops(complex));
    const double area = meshArea(body.mesh), volume = signedVolume(body.mesh);
    EXPECT_NEAR(exteriorArea(complex), area, 1e-9 * area);
    EXPECT_LT(excessTriangleArea(complex), 1e-9 * area);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), volume, 1e-9 * volume);
    const std::vector<Particle> particles = massProperties(body.mesh, body.queries, complex);
    for (size_t cell = 0; cell < volumes.size(); ++cell)
        EXPECT_NEAR(particles[cell].volume, volumes[cell], 1e-12 * volume) << "triangles against loops";
}

/// Every piece of surface of the right prong, and no border of cells on it.
void expectRightProngIsOf(uint32_t cell, const CellComplex& complex) {
    size_t pieces = 0;
    for (const ExteriorPiece& piece : complex.pieces) {
        const Double3& p = complex.vertices[complex.exterior_loop[piece.first]].position;
        if (p.x < 1.9 || p.y < 1.1) continue;
        ++pieces;
        EXPECT_EQ(piece.cell, cell);
        for (uint32_t k = piece.first; k < piece.first + piece.count; ++k)
            EXPECT_EQ(complex.exterior_across[k], kNoCell);
    }
    EXPECT_GT(pieces, 4u);
}

TEST(CutOffParts, TopOfTheOtherProngGoesToTheCellBelow) {
    const QueriedMesh fork(makeFork(1));
    const CellComplex complex = cut(fork, {kHigh, kBase});
    EXPECT_EQ(complex.moved_parts, 1u);
    expectWhole(complex, fork);
    // The bisector in the left prong: y = 2.75 + (x - 1) / 4.5.
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(volumes[0], 3.25 + 0.5 / 4.5, 1e-12);
    EXPECT_NEAR(volumes[1], 13 - volumes[0], 1e-12);
    expectRightProngIsOf(1, complex);
    ASSERT_EQ(complex.faces.size(), 1u) << "the face in the right prong is inside one cell now";
    const std::vector<BondGeometry> bonds = makeBonds(complex, 1);
    ASSERT_EQ(bonds.size(), 1u);
    EXPECT_NEAR(bonds[0].area, std::hypot(1, 1 / 4.5), 1e-12);
    EXPECT_NEAR(bonds[0].centroid.x, 0.5, 1e-12);
}

TEST(CutOffParts, GoOnToWhereTheirNeighbourWent) {
    const QueriedMesh fork(makeFork(1));
    const CellComplex complex = cut(fork, {kHigh, kMiddle, kBase});
    EXPECT_EQ(complex.moved_parts, 2u);
    expectWhole(complex, fork);
    const std::vector<double> volumes = loopVolumes(complex);
    EXPECT_NEAR(volumes[0], 2, 1e-12);
    EXPECT_NEAR(volumes[1], 2.25 + 0.5 / 2.5, 1e-12);  // bisector y = 1.75 + (x - 1) / 2.5
    EXPECT_NEAR(volumes[2], 13 - volumes[0] - volumes[1], 1e-12);
    expectRightProngIsOf(2, complex);
}

TEST(CutOffParts, OfWhichEachSharesMostWithTheOtherStillFindAPlace) {
    const QueriedMesh fork(makeFork(0.5));  // below, the two hang on a neck
    const CellComplex complex = cut(fork, {kHigh, kMiddle, kBase});
    EXPECT_EQ(complex.moved_parts, 2u);
    expectWhole(complex, fork);
    EXPECT_NEAR(loopVolumes(complex)[2], 11.5 - 2 - 2.45, 1e-12);
    expectRightProngIsOf(2, complex);
}

TEST(CutOffParts, TurnFacesWhoseOrderOfCellsChanges) {
    const QueriedMesh fork(makeFork(1));
    const CellComplex complex = cut(fork, {kBase, kHigh, kMiddle});
    EXPECT_EQ(complex.moved_parts, 2u);
    expectWhole(complex, fork);
    EXPECT_NEAR(loopVolumes(complex)[1], 2, 1e-12);
    for (const ComplexFace& face : complex.faces) EXPECT_LT(face.cell_a, face.cell_b);
}

TEST(CutOffParts, LargestPartStaysAndOneWithoutNeighbourToo) {
    // The second cube lies in the cell of the seed on its side; the seed's own half of the first cube is the
    // smaller part and goes to the other seed.
    const QueriedMesh cubes(joined(makeCube(1), makeCube(1), {3, 0, 0}));
    const CellComplex complex = cut(cubes, {{-0.2, 0.01, 0}, {0.2, 0.01, 0}});
    EXPECT_EQ(complex.moved_parts, 1u);
    expectWhole(complex, cubes);
    for (const double volume : loopVolumes(complex)) EXPECT_NEAR(volume, 1, 1e-12);
    EXPECT_TRUE(complex.faces.empty());
    // A smaller island stays, for want of a neighbour.
    const QueriedMesh island(joined(makeCube(1), makeCube(0.5), {3, 0, 0}));
    const CellComplex kept = cut(island, {{-0.2, 0.01, 0}, {0.2, 0.01, 0}});
    EXPECT_EQ(kept.moved_parts, 0u);
    EXPECT_NEAR(loopVolumes(kept)[1], 0.5 + 0.125, 1e-12);
}

TEST(CutOffParts, CavitiesStay) {
    const QueriedMesh box(joined(makeCube(1), turnedInsideOut(makeCube(0.2)), {0.3, 0, 0}));
    const CellComplex complex = cut(box, {{-0.25, 0.01, 0}, {0.25, 0.01, 0}});
    EXPECT_EQ(complex.moved_parts, 0u);
    EXPECT_NEAR(loopVolumes(complex)[1], 0.5 - 0.008, 1e-12);
}

}  // namespace
}  // namespace demolish::test
