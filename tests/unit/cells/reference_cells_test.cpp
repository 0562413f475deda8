// SPDX-License-Identifier: Apache-2.0
// Cells of a box against voro++, an independent implementation.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <voro++/voro++.hh>

#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/cells/test_bodies.h"

namespace demolish::test {
namespace {

struct ReferenceCell {
    double volume = 0;
    std::map<uint32_t, double> area_by_neighbour;  // m^2
};

std::vector<ReferenceCell> referenceCells(const std::vector<Double3>& seeds) {
    voro::container container(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5, 6, 6, 6, false, false, false, 8);
    for (size_t i = 0; i < seeds.size(); ++i) container.put(int(i), seeds[i].x, seeds[i].y, seeds[i].z);
    std::vector<ReferenceCell> cells(seeds.size());
    voro::c_loop_all loop(container);
    voro::voronoicell_neighbor cell;
    if (loop.start()) do {
            if (!container.compute_cell(cell, loop)) continue;
            ReferenceCell& reference = cells[size_t(loop.pid())];
            reference.volume = cell.volume();
            std::vector<int> neighbours;
            std::vector<double> areas;
            cell.neighbors(neighbours);
            cell.face_areas(areas);
            for (size_t f = 0; f < neighbours.size(); ++f)
                if (neighbours[f] >= 0) reference.area_by_neighbour[uint32_t(neighbours[f])] = areas[f];
        } while (loop.inc());
    return cells;
}

TEST(ReferenceCells, SameVolumesNeighboursAndFaceAreas) {
    const QueriedMesh& cube = *testBody("cube");
    const std::vector<Double3> seeds = randomSeeds(cube.mesh, cube.queries, 1000, 11);
    const CellComplex complex = buildCellComplex(cube.mesh, cube.queries, seeds, 0.1, 1);
    const std::vector<ReferenceCell> reference = referenceCells(seeds);
    const std::vector<double> volumes = loopVolumes(complex);
    std::vector<std::map<uint32_t, double>> areas(seeds.size());
    for (const ComplexFace& face : complex.faces) {
        areas[face.cell_a][face.cell_b] += face.area;
        areas[face.cell_b][face.cell_a] += face.area;
    }
    for (size_t i = 0; i < seeds.size(); ++i) {
        ASSERT_NEAR(volumes[i], reference[i].volume, 1e-14);
        ASSERT_EQ(areas[i].size(), reference[i].area_by_neighbour.size()) << "cell " << i;
        for (const auto& [neighbour, area] : reference[i].area_by_neighbour) {
            ASSERT_TRUE(areas[i].contains(neighbour)) << "cells " << i << " and " << neighbour;
            ASSERT_NEAR(areas[i][neighbour], area, 1e-13);
        }
    }
}

}  // namespace
}  // namespace demolish::test
