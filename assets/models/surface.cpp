// SPDX-License-Identifier: Apache-2.0
// Topology by counting, parts by union-find.
#include "assets/models/surface.h"

#include <algorithm>
#include <numeric>

namespace demolish::sculptor {
namespace {

/// Root of each vertex' connected part; the root is the part's smallest vertex.
std::vector<std::uint32_t> partRoots(const Surface& surface) {
    std::vector<std::uint32_t> parent(surface.positions.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto find = [&](std::uint32_t v) {
        while (parent[v] != v) v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const Triangle& t : surface.triangles)
        for (int i = 1; i < 3; ++i) {
            const auto a = find(t[0]), b = find(t[i]);
            parent[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = find(v);
    return parent;
}

}  // namespace

Topology topologyOf(const Surface& surface) {
    std::vector<std::uint64_t> forward, backward;
    std::vector<bool> used(surface.positions.size());
    for (const Triangle& t : surface.triangles)
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = t[i], b = t[(i + 1) % 3];
            used[a] = true;
            forward.push_back(a << 32 | b);
            backward.push_back(b << 32 | a);
        }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    Topology topology;
    topology.closed = !forward.empty() && forward == backward &&
                      std::adjacent_find(forward.begin(), forward.end()) == forward.end();
    for (std::uint64_t& edge : forward) edge = std::min(edge, edge << 32 | edge >> 32);
    std::sort(forward.begin(), forward.end());
    const auto edges = std::unique(forward.begin(), forward.end()) - forward.begin();
    topology.euler = std::count(used.begin(), used.end(), true) - edges +
                     static_cast<std::int64_t>(surface.triangles.size());
    const auto roots = partRoots(surface);
    for (std::uint32_t v = 0; v < roots.size(); ++v)
        if (used[v] && roots[v] == v) ++topology.parts;
    return topology;
}

double volumeOf(const Surface& surface) {
    double six_volumes = 0;
    const auto& p = surface.positions;
    for (const Triangle& t : surface.triangles) six_volumes += dot(p[t[0]], cross(p[t[1]], p[t[2]]));
    return six_volumes / 6;
}

Vec3 areaNormal(const Surface& surface, const Triangle& t) {
    const auto& p = surface.positions;
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

Surface largestPart(const Surface& surface) {
    const auto roots = partRoots(surface);
    std::vector<std::size_t> sizes(roots.size());
    for (const Triangle& t : surface.triangles) ++sizes[roots[t[0]]];
    const auto best =
        static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    Surface part;
    std::vector<std::uint32_t> renumbered(roots.size());
    for (std::uint32_t v = 0; v < roots.size(); ++v) {
        if (roots[v] != best) continue;
        renumbered[v] = static_cast<std::uint32_t>(part.positions.size());
        part.positions.push_back(surface.positions[v]);
    }
    for (const Triangle& t : surface.triangles)
        if (roots[t[0]] == best)
            part.triangles.push_back({renumbered[t[0]], renumbered[t[1]], renumbered[t[2]]});
    return part;
}

}  // namespace demolish::sculptor
