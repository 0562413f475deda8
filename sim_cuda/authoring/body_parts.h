// SPDX-License-Identifier: Apache-2.0
// What is read off a cell complex: mass properties, bonds, draw geometry. Each is pure and stands alone.
#pragma once
#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

/// Volume, centroid and inertia of every clipped cell by the divergence theorem; depth and lowest point.
std::vector<Particle> massProperties(const TriangleMesh& mesh, const MeshQueries& queries,
                                     const CellComplex& complex);

/// One bond per pair with shared area >= 0.02 h^2, sorted by (i, j). `spacing` in m; `cell_spacing`: that of
/// each cell where they are graded, else empty.
std::vector<BondGeometry> makeBonds(const CellComplex& complex, double spacing,
                                    const std::vector<double>& cell_spacing = {});

/// P, F, I, X, K of geometry.md 6, with faces tessellated for crack relaxation. cell_spacing: as makeBonds().
FractureGeometry makeFractureGeometry(const TriangleMesh& mesh, const CellComplex& complex,
                                      const std::vector<BondGeometry>& bonds,
                                      const std::vector<double>& cell_spacing = {});

}  // namespace demolish
