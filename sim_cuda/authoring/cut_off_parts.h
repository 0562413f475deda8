// SPDX-License-Identifier: Apache-2.0
// In thin or folded solids a Voronoi cell may hold several separate parts of solid (geometry.md 2.6).
#pragma once
#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

/// The largest part stays with the cell; each other one goes to the cell behind the neighbouring part with
/// which it shares most area, so that it does not fly with a seed that it never touched. Parts of negative
/// volume are cavities and stay; so do parts without a neighbour. Faces within one cell are left out then.
/// Wants closed cells. Vertices may be left unused. Returns how many parts were moved.
uint32_t moveCutOffParts(CellComplex& complex);

}  // namespace demolish
