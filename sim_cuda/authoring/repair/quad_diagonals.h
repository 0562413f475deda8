// SPDX-License-Identifier: Apache-2.0
// Quads that are there twice, cut along different diagonals.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// Where two triangles make an all but flat quad and two others the same quad cut the other way, as the
/// second side of a surface exported with both sides is cut, the latter are cut as the former: then they are
/// doubles. Returns how many quads were cut anew.
size_t alignDiagonals(RepairMesh& repair);

}  // namespace demolish
