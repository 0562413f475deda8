// SPDX-License-Identifier: Apache-2.0
// Numbers for the undirected edges of a mesh: the ids behind keys of kind B (geometry.md 2.1).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

struct MeshEdges {
    explicit MeshEdges(const TriangleMesh& mesh);

    std::vector<std::array<uint32_t, 2>> ends;         ///< lower vertex, higher vertex; sorted by them
    std::vector<std::array<uint32_t, 3>> of_triangle;  ///< edge from corner k to corner k + 1
};

}  // namespace demolish
