// SPDX-License-Identifier: Apache-2.0
// Measures of a cell complex that the tests compare with those of the mesh.
#pragma once
#include <vector>

#include "sim_cuda/authoring/cell_complex.h"

namespace demolish::test {

/// `count` independent random points inside the mesh.
std::vector<Double3> randomSeeds(const TriangleMesh& mesh, const MeshQueries& queries, uint32_t count,
                                 uint64_t seed);

/// h = (V / N)^(1/3), m.
double spacingOf(const TriangleMesh& mesh, size_t count);

double meshArea(const TriangleMesh& mesh);

/// m^2, by fans of the pieces.
double exteriorArea(const CellComplex& complex);

/// m^3 by cell, from loops alone (fans), so that it does not rest on the triangulation.
std::vector<double> loopVolumes(const CellComplex& complex);

/// Cells with an edge used not equally often in both directions.
size_t countOpenCells(const CellComplex& complex);

/// Parts of cells (by shared vertices) besides the largest of each that hold solid and share a face with
/// another cell.
size_t countCutOffParts(const CellComplex& complex);

/// m^2, how much more the face triangles cover than the faces: triangles that overlap or are flipped.
double excessTriangleArea(const CellComplex& complex);

/// Does every face's triangulation have the border of its loops?
bool triangulationsFitLoops(const CellComplex& complex);

}  // namespace demolish::test
