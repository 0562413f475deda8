// SPDX-License-Identifier: Apache-2.0
// Edges found by sorting the triangles' sides into their lower vertex.
#include "sim_cuda/authoring/mesh_edges.h"

#include <algorithm>

namespace demolish {

namespace {

struct Side {
    uint32_t higher, triangle, corner;
};

}  // namespace

MeshEdges::MeshEdges(const TriangleMesh& mesh) : of_triangle(mesh.triangles.size()) {
    std::vector<uint32_t> start(mesh.positions.size() + 1, 0);
    const auto forEachSide = [&](auto&& visit) {
        for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (uint32_t corner = 0; corner < 3; ++corner) {
                const uint32_t a = mesh.triangles[t][corner], b = mesh.triangles[t][(corner + 1) % 3];
                visit(std::min(a, b), Side{std::max(a, b), t, corner});
            }
    };
    forEachSide([&](uint32_t lower, const Side&) { ++start[lower + 1]; });
    for (size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<Side> sides(mesh.triangles.size() * 3);
    std::vector<uint32_t> next(start.begin(), start.end() - 1);
    forEachSide([&](uint32_t lower, const Side& side) { sides[next[lower]++] = side; });

    ends.reserve(sides.size() / 2);
    for (uint32_t lower = 0; lower + 1 < start.size(); ++lower) {
        const auto begin = sides.begin() + start[lower], end = sides.begin() + start[lower + 1];
        std::sort(begin, end, [](const Side& a, const Side& b) { return a.higher < b.higher; });
        for (auto side = begin; side != end; ++side) {
            if (side == begin || side->higher != (side - 1)->higher) ends.push_back({lower, side->higher});
            of_triangle[side->triangle][side->corner] = uint32_t(ends.size() - 1);
        }
    }
}

}  // namespace demolish
