// SPDX-License-Identifier: Apache-2.0
// A convex body cut into slabs by planes x = const: a cell complex made by hand, with surface vertices only.
#pragma once
#include "sim_cuda/authoring/cell_complex.h"

namespace demolish::test {

/// One cell per seed; seeds differ in x alone and ascend. No mesh vertex may lie on a cutting plane.
CellComplex makeSlabComplex(const TriangleMesh& mesh, const std::vector<double>& seed_x);

}  // namespace demolish::test
