// SPDX-License-Identifier: Apache-2.0
// Quick proof that cells are closed (geometry.md 2.5).
#pragma once
#include <vector>

#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

/// Cells with an edge that is not used equally often in both directions, sorted. By sums of a hash that
/// changes sign with the edge's direction: an open cell is missed with probability 2^-64.
std::vector<uint32_t> findOpenCells(const CellComplex& complex);

}  // namespace demolish
