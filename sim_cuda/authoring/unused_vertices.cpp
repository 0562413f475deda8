// SPDX-License-Identifier: Apache-2.0
// Vertices that no triangle uses.
#include "sim_cuda/authoring/unused_vertices.h"

namespace demolish {

void dropUnusedVertices(TriangleMesh& mesh) {
    constexpr uint32_t kUnused = 0xffffffffu;
    std::vector<uint32_t> new_id(mesh.positions.size(), kUnused);
    for (const auto& t : mesh.triangles)
        for (const uint32_t v : t) new_id[v] = 0;
    uint32_t count = 0;
    for (size_t v = 0; v < new_id.size(); ++v) {
        if (new_id[v] == kUnused) continue;
        mesh.positions[count] = mesh.positions[v];
        new_id[v] = count++;
    }
    mesh.positions.resize(count);
    for (auto& t : mesh.triangles)
        for (uint32_t& v : t) v = new_id[v];
}

}  // namespace demolish
