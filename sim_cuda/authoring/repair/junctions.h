// SPDX-License-Identifier: Apache-2.0
// Edges where three and more faces meet.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct JunctionCounts {
    size_t edges = 0;   ///< of three and more faces
    size_t turned = 0;  ///< patches
    size_t walls = 0;   ///< patches dropped: without them the edges about them are balanced
    size_t fins = 0;    ///< such patches with free edges: sheets that stand on the rest, parts of their own
};

/// Turns whole patches while that lowers the sum of imbalance at these edges, then finds walls and fins.
/// Numbers the parts anew. After orientPatches().
JunctionCounts solveJunctions(RepairMesh& repair);

}  // namespace demolish
