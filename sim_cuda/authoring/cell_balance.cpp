// SPDX-License-Identifier: Apache-2.0
// Edge balance of cells: counted by vertex ids for tests, by hash sums for every build.
#include "sim_cuda/authoring/cell_balance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

#include "sim_cuda/physics/random.h"

namespace demolish {

namespace {

/// Calls visit(cell, from, to) for every directed edge of every cell's surface.
template <typename Visit>
void forEachCellEdge(const CellComplex& complex, Visit&& visit) {
    const auto loop = [&](const uint32_t* ids, uint32_t count, auto&& edge) {
        for (uint32_t k = 0; k < count; ++k) edge(ids[k], ids[k + 1 < count ? k + 1 : 0]);
    };
    for (const ExteriorPiece& piece : complex.pieces)
        loop(complex.exterior_loop.data() + piece.first, piece.count,
             [&](uint32_t from, uint32_t to) { visit(piece.cell, from, to); });
    for (const ComplexFace& face : complex.faces)
        for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l)
            loop(complex.loop_vertices.data() + complex.loop_start[l],
                 complex.loop_start[l + 1] - complex.loop_start[l], [&](uint32_t from, uint32_t to) {
                     visit(face.cell_a, from, to);
                     visit(face.cell_b, to, from);
                 });
}

uint64_t edgeHash(uint32_t from, uint32_t to) {
    if (from == to) return 0;
    const uint64_t hash = counterHash(std::min(from, to), std::max(from, to));
    return from < to ? hash : uint64_t(0) - hash;
}

struct Edge {
    uint32_t low, high;
    int direction;
};

uint32_t countUnbalanced(Edge* begin, Edge* end) {
    std::sort(begin, end,
              [](const Edge& a, const Edge& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
    uint32_t unbalanced = 0;
    while (begin != end) {
        int sum = 0;
        const Edge* first = begin;
        for (; begin != end && begin->low == first->low && begin->high == first->high; ++begin)
            sum += begin->direction;
        unbalanced += sum != 0 && first->low != first->high;
    }
    return unbalanced;
}

}  // namespace

std::vector<uint32_t> findOpenCells(const CellComplex& complex) {
    std::vector<uint64_t> sums(complex.seeds.size(), 0);
    forEachCellEdge(complex,
                    [&](uint32_t cell, uint32_t from, uint32_t to) { sums[cell] += edgeHash(from, to); });
    std::vector<uint32_t> open;
    for (uint32_t cell = 0; cell < sums.size(); ++cell)
        if (sums[cell] != 0) open.push_back(cell);
    return open;
}

std::vector<uint32_t> unbalancedEdges(const CellComplex& complex) {
    const size_t cell_count = complex.seeds.size();
    std::vector<size_t> start(cell_count + 1, 0);
    forEachCellEdge(complex, [&](uint32_t cell, uint32_t, uint32_t) { ++start[cell + 1]; });
    for (size_t cell = 1; cell <= cell_count; ++cell) start[cell] += start[cell - 1];
    std::vector<Edge> edges(start.back());
    std::vector<size_t> next(start.begin(), start.end() - 1);
    forEachCellEdge(complex, [&](uint32_t cell, uint32_t from, uint32_t to) {
        edges[next[cell]++] = from < to ? Edge{from, to, 1} : Edge{to, from, -1};
    });
    std::vector<uint32_t> result(cell_count, 0);
    tbb::parallel_for(size_t(0), cell_count, [&](size_t cell) {
        result[cell] = countUnbalanced(edges.data() + start[cell], edges.data() + start[cell + 1]);
    });
    return result;
}

}  // namespace demolish
