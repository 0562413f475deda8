// SPDX-License-Identifier: Apache-2.0
// Every part is moved as a whole, so that it keeps its shape.
#include "sim_cuda/authoring/repair/parts_apart.h"

#include <map>
#include <utility>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/hash_random.h"

namespace demolish {

void setPartsApart(RepairMesh& repair, double most) {
    constexpr uint64_t kSeed = 1, kStream = 0x6170617274;
    if (repair.parts < 2) return;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> ids;
    std::vector<Double3> positions;
    for (size_t t = 0; t < repair.size(); ++t)
        for (uint32_t& vertex : repair.mesh.triangles[t]) {
            const uint32_t part = repair.part[t];
            const auto [place, is_new] = ids.try_emplace({part, vertex}, uint32_t(positions.size()));
            if (is_new) {
                const Double3 shift = part == 0 ? Double3{} : hashRandomInCube(kSeed, kStream, part);
                positions.push_back(repair.mesh.positions[vertex] + shift * (2 * most));
            }
            vertex = place->second;
        }
    repair.mesh.positions = std::move(positions);
}

}  // namespace demolish
