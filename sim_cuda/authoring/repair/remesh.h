// SPDX-License-Identifier: Apache-2.0
// A new surface about what a mesh holds, whatever its triangles.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

inline constexpr int kRemeshCells = 128;  ///< along the diagonal; finer features go

/// Closed, outside out, every volume counted once. Each triangle takes its source, texture coordinates and
/// normals from the nearest triangle of `original`: coordinates go on over its plane, so that nothing smears
/// over seams. `is_closed`: no edge of the original is open, see insideField().
RepairMesh remeshed(const RepairMesh& original, bool is_closed, int cells = kRemeshCells);

}  // namespace demolish
