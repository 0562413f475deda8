// SPDX-License-Identifier: Apache-2.0
// Vertices that no triangle uses.
#pragma once
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// Removes them; the others keep their order.
void dropUnusedVertices(TriangleMesh& mesh);

}  // namespace demolish
