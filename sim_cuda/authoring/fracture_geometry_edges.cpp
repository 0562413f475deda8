// SPDX-License-Identifier: Apache-2.0
// Voronoi edges inside the solid and their cuts: done once an edge, so that every face round it gets the same
// vertices.
#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/fracture_geometry_parts.h"

namespace demolish {
namespace {

constexpr uint32_t kMostParts = 64;  // a cell of a handful in a slender body may have very long edges

/// Neighbours in a face's loop lie on one Voronoi edge when they share its three seeds. Two C vertices may
/// also be joined by a segment in their mesh triangle; then their third seeds differ.
bool onOneVoronoiEdge(const VertexKey& u, const VertexKey& v) {
    const VertexKey& c = u.kind == VertexKind::kTriangle ? u : v;
    const VertexKey& other = u.kind == VertexKind::kTriangle ? v : u;
    if (c.kind == VertexKind::kTriangle) {
        if (other.kind == VertexKind::kTriangle)
            return std::equal(c.ids.begin() + 1, c.ids.end(), other.ids.begin() + 1);
        return other.kind == VertexKind::kInterior &&
               std::includes(other.ids.begin(), other.ids.end(), c.ids.begin() + 1, c.ids.end());
    }
    if (u.kind != VertexKind::kInterior || v.kind != VertexKind::kInterior) return false;
    int shared = 0;
    for (const uint32_t id : u.ids)
        shared += std::find(v.ids.begin(), v.ids.end(), id) != v.ids.end() ? 1 : 0;
    return shared == 3;
}

/// Calls visit(lower, higher) for the Voronoi edges of every face: each edge as often as faces meet there.
template <class Visit>
void forEachVoronoiEdge(const CellComplex& complex, Visit&& visit) {
    for (const ComplexFace& face : complex.faces) {
        for (uint32_t loop = face.first_loop; loop < face.first_loop + face.loop_count; ++loop) {
            const uint32_t begin = complex.loop_start[loop], end = complex.loop_start[loop + 1];
            uint32_t u = complex.loop_vertices[end - 1];
            for (uint32_t at = begin; at < end; ++at) {
                const uint32_t v = complex.loop_vertices[at];
                if (onOneVoronoiEdge(complex.vertices[u].key, complex.vertices[v].key))
                    visit(std::min(u, v), std::max(u, v));
                u = v;
            }
        }
    }
}

/// Sorts each row and drops repetitions: the edge is met once by each of the three faces round it.
void uniqueRows(SplitEdges& split) {
    uint32_t kept = 0;
    uint32_t begin = 0;
    for (size_t row = 0; row + 1 < split.row_start.size(); ++row) {
        const uint32_t end = split.row_start[row + 1];
        const auto first = split.edges.begin() + begin, last = split.edges.begin() + end;
        std::sort(first, last, [](const auto& a, const auto& b) { return a.higher < b.higher; });
        const auto unique_end =
            std::unique(first, last, [](const auto& a, const auto& b) { return a.higher == b.higher; });
        split.row_start[row] = kept;
        std::copy(first, unique_end, split.edges.begin() + kept);
        kept += static_cast<uint32_t>(unique_end - first);
        begin = end;
    }
    split.row_start.back() = kept;
    split.edges.resize(kept);
}

void cutEdges(const CellComplex& complex, double longest, SplitEdges& split) {
    for (size_t row = 0; row + 1 < split.row_start.size(); ++row) {
        const Double3& low = complex.vertices[row].position;
        for (uint32_t e = split.row_start[row]; e < split.row_start[row + 1]; ++e) {
            SplitEdges::Edge& edge = split.edges[e];
            const Double3 along = complex.vertices[edge.higher].position - low;
            const double parts = std::ceil(length(along) / longest);
            edge.parts = static_cast<uint32_t>(std::clamp(parts, 1.0, static_cast<double>(kMostParts)));
            edge.first_split = static_cast<uint32_t>(split.points.size());
            for (uint32_t s = 1; s < edge.parts; ++s)
                split.points.push_back(low + along * (double(s) / edge.parts));
        }
    }
}

}  // namespace

const SplitEdges::Edge* SplitEdges::find(uint32_t u, uint32_t v) const {
    const uint32_t low = std::min(u, v), high = std::max(u, v);
    for (uint32_t e = row_start[low]; e < row_start[low + 1]; ++e)
        if (edges[e].higher == high) return &edges[e];
    return nullptr;
}

SplitEdges splitVoronoiEdges(const CellComplex& complex, double longest) {
    SplitEdges split;
    split.row_start.assign(complex.vertices.size() + 1, 0);
    forEachVoronoiEdge(complex, [&](uint32_t low, uint32_t) { ++split.row_start[low + 1]; });
    for (size_t row = 0; row + 1 < split.row_start.size(); ++row)
        split.row_start[row + 1] += split.row_start[row];
    split.edges.resize(split.row_start.back());
    std::vector<uint32_t> cursor(split.row_start.begin(), split.row_start.end() - 1);
    forEachVoronoiEdge(complex, [&](uint32_t low, uint32_t high) {
        split.edges[cursor[low]++] = {high, 0, 1};
    });
    uniqueRows(split);
    cutEdges(complex, longest, split);
    return split;
}

}  // namespace demolish
