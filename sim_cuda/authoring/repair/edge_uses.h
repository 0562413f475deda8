// SPDX-License-Identifier: Apache-2.0
// Which triangles use an edge, and in which direction.
#pragma once
#include <span>
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

struct EdgeUse {
    uint32_t group;  ///< what the triangle belongs to: uses of different groups are of different edges
    uint32_t low, high;
    uint32_t triangle;
    int direction;  ///< 1 from low to high, -1 back

    bool sameEdge(const EdgeUse& other) const {
        return group == other.group && low == other.low && high == other.high;
    }
};

/// Three for each triangle, sorted by group, edge and triangle. `group` by triangle; empty: all are of one.
std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh, const std::vector<uint32_t>& group = {});

/// Calls visit(std::span<const EdgeUse>) for each edge in order.
template <typename Visit>
void forEachEdge(const std::vector<EdgeUse>& uses, Visit&& visit) {
    for (size_t begin = 0; begin < uses.size();) {
        size_t end = begin + 1;
        while (end < uses.size() && uses[end].sameEdge(uses[begin])) ++end;
        visit(std::span<const EdgeUse>(uses).subspan(begin, end - begin));
        begin = end;
    }
}

/// Uses in direction of its numbers less those against it: 0 where the edge is closed.
inline int imbalanceOf(std::span<const EdgeUse> edge) {
    int sum = 0;
    for (const EdgeUse& use : edge) sum += use.direction;
    return sum;
}

}  // namespace demolish
