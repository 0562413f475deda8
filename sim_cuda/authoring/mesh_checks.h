// SPDX-License-Identifier: Apache-2.0
// What a mesh must satisfy before it can be filled: closed, and with a volume.
#pragma once
#include <cstddef>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// Edges that are not used equally often in both directions (geometry.md 0.1); 0 for a closed, consistently
/// turned mesh.
size_t openEdgeCount(const TriangleMesh& mesh);

/// Triangles that are there more than once with the same side out: a surface that was exported twice, which
/// would enclose everything twice.
size_t repeatedTriangleCount(const TriangleMesh& mesh);

/// m^3, by the divergence theorem about the middle of the bounds; negative when the triangles face inwards.
double enclosedVolume(const TriangleMesh& mesh);

/// m^2
double surfaceArea(const TriangleMesh& mesh);

}  // namespace demolish
