// SPDX-License-Identifier: Apache-2.0
// A closed surface between the nodes inside and those outside (Ju et al. 2002).
#pragma once
#include "sim_cuda/authoring/distance_field.h"
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// One vertex for each cell that the surface passes, at the point that fits best the planes of the nearest
/// triangles of `original`, two triangles for each grid edge between an inner and an outer node. Every edge
/// is balanced; edges of the original stay sharp. Corners are left empty (mesh.corners has no entries). The
/// same for any number of threads.
TriangleMesh dualContour(const std::vector<float>& field, const NodeFrame& frame,
                         const TriangleMesh& original, const MeshQueries& queries);

}  // namespace demolish
