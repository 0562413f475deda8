// SPDX-License-Identifier: Apache-2.0
// Neighbouring triangles with the same side out.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct Orientation {
    size_t turned = 0;                ///< triangles
    std::vector<char> patch_touched;  ///< by patch: some of its triangles were turned
};

/// Numbers patches and parts. Within a patch all triangles get the direction of those that hold the larger
/// area of it.
Orientation orientPatches(RepairMesh& repair);

/// Numbers the parts anew: triangles that share an edge, unless `apart` (by patch; empty: none) tells them
/// apart.
void numberParts(RepairMesh& repair, const std::vector<uint32_t>& apart = {});

}  // namespace demolish
