// SPDX-License-Identifier: Apache-2.0
// Patches grow from triangle to triangle over edges of two faces.
#include "sim_cuda/authoring/repair/orientation.h"

#include <utility>

#include "sim_cuda/authoring/repair/disjoint_sets.h"
#include "sim_cuda/authoring/repair/edge_uses.h"

namespace demolish {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// Over an edge of two faces, by triangle and its side; kNone where there is none.
struct Neighbour {
    uint32_t triangle = kNone;
    bool same_direction = false;  ///< both use the edge the same way, so one of them lies wrong
};

std::vector<std::array<Neighbour, 3>> neighboursOf(const TriangleMesh& mesh) {
    std::vector<std::array<Neighbour, 3>> all(mesh.triangles.size());
    std::vector<uint8_t> count(mesh.triangles.size(), 0);
    const std::vector<EdgeUse> uses = edgeUses(mesh);
    forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
        if (edge.size() != 2) return;
        const bool same = edge[0].direction == edge[1].direction;
        for (size_t i = 0; i < 2; ++i) {
            const uint32_t t = edge[i].triangle;
            all[t][count[t]++] = {edge[1 - i].triangle, same};
        }
    });
    return all;
}

}  // namespace

void numberParts(RepairMesh& repair, const std::vector<uint32_t>& apart) {
    DisjointSets sets(repair.size());
    std::vector<uint32_t> group(repair.size(), 0);
    if (!apart.empty())
        for (size_t t = 0; t < repair.size(); ++t) group[t] = apart[repair.patch[t]];
    const std::vector<EdgeUse> uses = edgeUses(repair.mesh, group);
    forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
        for (const EdgeUse& use : edge) sets.join(edge[0].triangle, use.triangle);
    });
    repair.parts = sets.number(repair.part);
}

Orientation orientPatches(RepairMesh& repair) {
    Orientation result;
    const auto neighbours = neighboursOf(repair.mesh);
    repair.patch.assign(repair.size(), kNone);
    repair.patches = 0;
    std::vector<char> is_turned(repair.size(), 0);
    std::vector<uint32_t> members;
    for (uint32_t seed = 0; seed < repair.size(); ++seed) {
        if (repair.patch[seed] != kNone) continue;
        members.assign(1, seed);
        repair.patch[seed] = repair.patches;
        std::array<double, 2> area{};  // as it was, turned
        for (size_t i = 0; i < members.size(); ++i) {
            const uint32_t t = members[i];
            area[size_t(is_turned[t])] += repair.area(t);
            for (const auto& [other, same_direction] : neighbours[t]) {
                if (other == kNone || repair.patch[other] != kNone) continue;
                repair.patch[other] = repair.patches;
                is_turned[other] = char(is_turned[t] ^ char(same_direction));
                members.push_back(other);
            }
        }
        bool touched = false;
        for (const uint32_t t : members) {
            is_turned[t] ^= char(area[1] > area[0]);
            touched = touched || is_turned[t] != 0;
        }
        result.patch_touched.push_back(touched);
        ++repair.patches;
    }
    for (size_t t = 0; t < repair.size(); ++t)
        if (is_turned[t] != 0) {
            repair.turn(t);
            ++result.turned;
        }
    numberParts(repair);
    return result;
}

}  // namespace demolish
