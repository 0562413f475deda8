// SPDX-License-Identifier: Apache-2.0
// What is known of cells and their cubes before the mesh is clipped.
#include "sim_cuda/authoring/exterior_pieces.h"

#include <gtest/gtest.h>

#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

TEST(ExteriorPieces, CubesThatHoldTheirVerticesHoldAllPieces) {
    const TriangleMesh sphere = makeSphere(1, 4);
    const MeshEdges edges(sphere);
    const std::vector<Double3> seeds{
        {0.05, 0.04, 0.03}, {-0.05, 0.02, 0.06}, {0.01, -0.05, -0.04}, {0.02, 0.07, -0.06}};
    const KeySpace space{sphere, edges, seeds};
    constexpr double kSpacing = 0.1;  // far less than what a seed's cell spans
    VoronoiCells cells(seeds, kSpacing);
    ExteriorPieces pieces(space, cells);
    EXPECT_EQ(pieces.cellsWithVerticesBeyondTheirCube(), (std::vector<uint32_t>{0, 1, 2, 3}));
    for (int round = 0; round < 4; ++round) cells.doubleCubes({0, 1, 2, 3});
    EXPECT_TRUE(pieces.cellsWithVerticesBeyondTheirCube().empty());
    pieces.clip();
    EXPECT_TRUE(pieces.cellsThatOutgrowTheirCube().empty());
    EXPECT_EQ(pieces.gather().cell_start.back(), pieces.gather().pieces.size());
    EXPECT_GE(pieces.gather().pieces.size(), sphere.triangles.size());
}

}  // namespace
}  // namespace demolish::test
