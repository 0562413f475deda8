// SPDX-License-Identifier: Apache-2.0
// The corners on which a cell stands, slides and rolls.
#pragma once
#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

/// Vertices of each cell's hull, at most kMostCorners of them: those that leave the least of the hull outside
/// in any direction.
CellCorners cellCorners(const CellComplex& complex, double spacing);

/// The same of any points. Of fewer than kMostCorners nothing is left out.
std::vector<Double3> hullCorners(const std::vector<Double3>& points, double tolerance);

}  // namespace demolish
