// SPDX-License-Identifier: Apache-2.0
// Every part is moved as a whole, so that it keeps its shape.
#include "sim_cuda/authoring/repair/parts_apart.h"

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/hash_random.h"

namespace demolish {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// Of a vertex, for one part.
struct Copy {
    uint32_t part;
    uint32_t before;  ///< of the same vertex, for another part, or kNone
};

}  // namespace

void setPartsApart(RepairMesh& repair, double most) {
    constexpr uint64_t kSeed = 1, kStream = 0x6170617274;
    if (repair.parts < 2) return;
    std::vector<uint32_t> last(repair.mesh.positions.size(), kNone);  // copy of each vertex
    std::vector<Copy> copies;
    std::vector<Double3> positions;
    for (size_t t = 0; t < repair.size(); ++t)
        for (uint32_t& vertex : repair.mesh.triangles[t]) {
            const uint32_t part = repair.part[t];
            uint32_t copy = last[vertex];
            while (copy != kNone && copies[copy].part != part) copy = copies[copy].before;
            if (copy == kNone) {
                const Double3 shift = part == 0 ? Double3{} : hashRandomInCube(kSeed, kStream, part);
                positions.push_back(repair.mesh.positions[vertex] + shift * (2 * most));
                copy = uint32_t(copies.size());
                copies.push_back({part, last[vertex]});
                last[vertex] = copy;
            }
            vertex = copy;
        }
    repair.mesh.positions = std::move(positions);
}

}  // namespace demolish
