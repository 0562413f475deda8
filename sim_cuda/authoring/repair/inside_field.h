// SPDX-License-Identifier: Apache-2.0
// How far inside or outside the nodes of a grid are, for the remesh.
#pragma once
#include <vector>

#include "sim_cuda/authoring/distance_field.h"
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// A grid with room about the mesh, `cells` of it along the mesh's diagonal.
NodeFrame frameAbout(const TriangleMesh& mesh, int cells);

/// m by node, negative inside, never 0, positive on the frame's border. Of a closed mesh: inside is where its
/// winding number is above 0, so that overlaps count once. Of any mesh: where the generalized winding number
/// is above a half; over holes the value goes smoothly through 0.
std::vector<float> insideField(const TriangleMesh& mesh, const MeshQueries& queries, const NodeFrame& frame,
                               bool is_closed);

}  // namespace demolish
