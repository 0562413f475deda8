// SPDX-License-Identifier: Apache-2.0
// Triangles of the same three vertices.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct DoubleCounts {
    size_t same = 0;           ///< copies with the same side out, dropped
    size_t opposite_both = 0;  ///< pairs back to back of which none stayed
    size_t opposite_one = 0;   ///< pairs of which one stayed
};

/// Of triangles with the same side out one stays. Pairs back to back go or leave one by connected group:
/// where most of the group's border edges have an even number of other faces, the pairs are a wall inside of
/// something closed and go; else they are a surface that was exported with both sides.
DoubleCounts dropDoubles(RepairMesh& repair);

/// The last doubles of a mesh that is otherwise closed, without opening an edge: pairs back to back cancel,
/// further copies get a vertex in their middle.
void settleDoubles(RepairMesh& repair);

/// Triangles back to back that are of different parts cancel, and the parts become one.
void glueParts(RepairMesh& repair);

}  // namespace demolish
