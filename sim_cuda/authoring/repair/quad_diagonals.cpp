// SPDX-License-Identifier: Apache-2.0
// Quads of the same four vertices lie side by side once they are sorted by them.
#include "sim_cuda/authoring/repair/quad_diagonals.h"

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/repair/edge_uses.h"

namespace demolish {
namespace {

constexpr double kFlat = 0.9;  // cosine between the normals of both halves

/// Two triangles over a diagonal.
struct Quad {
    std::array<uint32_t, 4> sorted;     // vertices
    std::array<uint32_t, 2> diagonal;   // vertices, the lower first
    std::array<uint32_t, 2> triangles;  // the lower first
};

size_t placeOf(const Triangle& triangle, uint32_t vertex) {
    return size_t(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

uint32_t vertexBeside(const Triangle& triangle, const EdgeUse& edge) {
    return triangle[0] + triangle[1] + triangle[2] - edge.low - edge.high;
}

std::vector<Quad> flatQuads(const RepairMesh& repair) {
    std::vector<Quad> quads;
    const std::vector<EdgeUse> uses = edgeUses(repair.mesh);
    forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
        if (edge.size() != 2 || edge[0].direction == edge[1].direction) return;
        const uint32_t one = edge[0].triangle, other = edge[1].triangle;
        if (!(dot(repair.normal(one), repair.normal(other)) > kFlat)) return;
        Quad quad{{edge[0].low, edge[0].high, vertexBeside(repair.mesh.triangles[one], edge[0]),
                   vertexBeside(repair.mesh.triangles[other], edge[0])},
                  {edge[0].low, edge[0].high},
                  {one, other}};
        std::sort(quad.sorted.begin(), quad.sorted.end());
        quads.push_back(quad);
    });
    std::sort(quads.begin(), quads.end(), [](const Quad& a, const Quad& b) {
        return a.sorted != b.sorted ? a.sorted < b.sorted : a.triangles < b.triangles;
    });
    return quads;
}

bool areCutCrosswise(const Quad& a, const Quad& b) {
    return a.sorted == b.sorted && a.diagonal[0] != b.diagonal[0] && a.diagonal[0] != b.diagonal[1] &&
           a.diagonal[1] != b.diagonal[0] && a.diagonal[1] != b.diagonal[1];
}

/// (u, v, p) and (v, u, q) become (p, u, q) and (q, v, p).
void cutOtherwise(RepairMesh& repair, const Quad& quad) {
    const auto [first, second] = quad.triangles;
    const Triangle one = repair.mesh.triangles[first], other = repair.mesh.triangles[second];
    const Corners of_one = repair.mesh.corners[first], of_other = repair.mesh.corners[second];
    size_t u = 0;
    while (one[u] == quad.diagonal[0] || one[u] == quad.diagonal[1]) ++u;
    const size_t p = u;
    u = (p + 1) % 3;
    const size_t v = (p + 2) % 3, other_u = placeOf(other, one[u]), q = (other_u + 1) % 3;
    repair.mesh.triangles[first] = {one[p], one[u], other[q]};
    repair.mesh.corners[first] = {of_one[p], of_one[u], of_other[q]};
    repair.mesh.triangles[second] = {other[q], one[v], one[p]};
    repair.mesh.corners[second] = {of_other[q], of_one[v], of_one[p]};
}

}  // namespace

size_t alignDiagonals(RepairMesh& repair) {
    const std::vector<Quad> quads = flatQuads(repair);
    std::vector<char> is_taken(repair.size(), 0);
    const auto isFree = [&](const Quad& quad) {
        return is_taken[quad.triangles[0]] == 0 && is_taken[quad.triangles[1]] == 0;
    };
    size_t cut = 0;
    for (size_t begin = 0, end = 0; begin < quads.size(); begin = end) {
        while (end < quads.size() && quads[end].sorted == quads[begin].sorted) ++end;
        for (size_t i = begin + 1; i < end; ++i) {
            if (!areCutCrosswise(quads[begin], quads[i]) || !isFree(quads[begin]) || !isFree(quads[i]))
                continue;
            cutOtherwise(repair, quads[i]);
            for (const uint32_t t : quads[i].triangles) is_taken[t] = 1;
            ++cut;
        }
        for (const uint32_t t : quads[begin].triangles) is_taken[t] = 1;
    }
    return cut;
}

}  // namespace demolish
