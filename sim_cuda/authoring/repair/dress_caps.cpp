// SPDX-License-Identifier: Apache-2.0
// Ring by ring from the borders inwards.
#include "sim_cuda/authoring/repair/dress_caps.h"

#include <algorithm>

namespace demolish {
namespace {

/// What is known at each vertex; no material: nothing.
using VertexLooks = std::vector<CornerAttributes>;

void tell(const RepairMesh& repair, size_t triangle, VertexLooks& at) {
    for (size_t k = 0; k < 3; ++k) {
        CornerAttributes& known = at[repair.mesh.triangles[triangle][k]];
        if (known.material == kNoMaterial) known = repair.mesh.corners[triangle][k];
    }
}

/// False where nothing is known at any corner.
bool dress(RepairMesh& repair, size_t triangle, const VertexLooks& at) {
    const Triangle& vertices = repair.mesh.triangles[triangle];
    const auto leader = std::find_if(vertices.begin(), vertices.end(),
                                     [&](uint32_t v) { return at[v].material != kNoMaterial; });
    if (leader == vertices.end()) return false;
    for (size_t k = 0; k < 3; ++k) {
        const CornerAttributes& own = at[vertices[k]];
        const CornerAttributes& from = own.material == at[*leader].material ? own : at[*leader];
        CornerAttributes& corner = repair.mesh.corners[triangle][k];
        corner.uv = from.uv;
        corner.second_uv = from.second_uv;
        corner.colour = from.colour;
        corner.material = from.material;
    }
    return true;
}

}  // namespace

void dressCaps(RepairMesh& repair) {
    std::vector<size_t> bare;
    VertexLooks at(repair.mesh.positions.size());
    bool any = false;
    for (size_t t = 0; t < repair.size(); ++t) {
        if (repair.mesh.corners[t][0].material == kNoMaterial) {
            bare.push_back(t);
        } else {
            tell(repair, t, at);
            any = true;
        }
    }
    while (any && !bare.empty()) {
        std::vector<size_t> dressed, left;
        for (const size_t t : bare) (dress(repair, t, at) ? dressed : left).push_back(t);
        if (dressed.empty()) return;
        for (const size_t t : dressed) tell(repair, t, at);
        bare = std::move(left);
    }
}

}  // namespace demolish
