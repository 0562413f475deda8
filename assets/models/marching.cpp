// SPDX-License-Identifier: Apache-2.0
// Marching tetrahedra: sample, cross the edges, then lay triangles through the crossings.
#include "assets/models/marching.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

namespace demolish::sculptor {
namespace {

/// Samples on a lattice. A lattice edge is named 8 * start + direction, the direction's bits being the axes
/// it steps along (1..7: the seven kinds of edge in Kuhn's split).
struct Lattice {
    Vec3 origin;
    double cell = 0;
    std::uint64_t nx = 0, ny = 0, nz = 0;
    std::vector<double> values;

    std::uint64_t index(std::uint64_t i, std::uint64_t j, std::uint64_t k) const {
        return (k * ny + j) * nx + i;
    }
    std::uint64_t step(unsigned direction) const {
        return (direction & 1) + (direction >> 1 & 1) * nx + (direction >> 2 & 1) * nx * ny;
    }
    Vec3 point(std::uint64_t v) const {
        const std::uint64_t column = v % nx, row = v / nx % ny, layer = v / (nx * ny);
        return {origin.x + cell * static_cast<double>(column), origin.y + cell * static_cast<double>(row),
                origin.z + cell * static_cast<double>(layer)};
    }
    bool inside(std::uint64_t v) const { return values[v] < 0; }
};

Lattice sample(const Distance& distance, const Box& box, double cell) {
    const auto count = [&](double low, double high) {
        return static_cast<std::uint64_t>(std::ceil((high - low) / cell)) + 5;
    };
    Lattice lattice;
    lattice.origin = box.low - Vec3{2 * cell, 2 * cell, 2 * cell};
    lattice.cell = cell;
    lattice.nx = count(box.low.x, box.high.x);
    lattice.ny = count(box.low.y, box.high.y);
    lattice.nz = count(box.low.z, box.high.z);
    lattice.values.resize(lattice.nx * lattice.ny * lattice.nz);
    tbb::parallel_for(std::size_t{0}, lattice.values.size(),
                      [&](std::size_t v) { lattice.values[v] = distance(lattice.point(v)); });
    return lattice;
}

/// Calls visit(lattice vertex) for the lowest corner of every cube, in scan order.
template <typename Visit>
void forEachCube(const Lattice& lattice, Visit visit) {
    for (std::uint64_t k = 0; k + 1 < lattice.nz; ++k)
        for (std::uint64_t j = 0; j + 1 < lattice.ny; ++j)
            for (std::uint64_t i = 0; i + 1 < lattice.nx; ++i) visit(lattice.index(i, j, k));
}

/// Names of the crossed edges, rising. Edges that start on the upper border belong to no cube and are not
/// crossed.
std::vector<std::uint64_t> crossedEdges(const Lattice& lattice) {
    std::vector<std::uint64_t> edges;
    const auto border = [&](std::uint64_t n, std::uint64_t i) { return i == 0 || i + 1 == n; };
    for (std::uint64_t v = 0; v < lattice.values.size(); ++v) {
        const std::uint64_t i = v % lattice.nx, j = v / lattice.nx % lattice.ny,
                            k = v / (lattice.nx * lattice.ny);
        const bool at_border = border(lattice.nx, i) || border(lattice.ny, j) || border(lattice.nz, k);
        if (at_border && lattice.inside(v)) throw std::runtime_error("the body leaves the marching grid");
        if (i + 1 == lattice.nx || j + 1 == lattice.ny || k + 1 == lattice.nz) continue;
        for (unsigned direction = 1; direction < 8; ++direction)
            if (lattice.inside(v) != lattice.inside(v + lattice.step(direction)))
                edges.push_back(8 * v + direction);
    }
    return edges;
}

Vec3 crossing(const Lattice& lattice, std::uint64_t edge) {
    const std::uint64_t a = edge / 8, b = a + lattice.step(edge % 8);
    const double fa = lattice.values[a], fb = lattice.values[b];
    const double t = std::clamp(fa / (fa - fb), 0.02, 0.98);
    const Vec3 pa = lattice.point(a);
    return pa + t * (lattice.point(b) - pa);
}

/// The surface inside one tetrahedron whose corners are the cube's corners `bits` (rising along the
/// diagonal).
class TetrahedronCutter {
  public:
    TetrahedronCutter(const Lattice& lattice, const std::vector<std::uint64_t>& edges,
                      std::vector<Triangle>& out)
        : lattice_(lattice), edges_(edges), out_(out) {}

    /// `positive`: corners 1..3 turn counterclockwise seen from outside corner 0.
    void cut(std::uint64_t cube, const std::array<unsigned, 4>& bits, bool positive) {
        std::array<int, 4> order;  // corners inside first, each group rising
        int inside = 0, filled = 0;
        for (int c = 0; c < 4; ++c)
            if (lattice_.inside(cube + lattice_.step(bits[c]))) order[filled++] = c, ++inside;
        if (inside == 0 || inside == 4) return;
        for (int c = 0; c < 4; ++c)
            if (!lattice_.inside(cube + lattice_.step(bits[c]))) order[filled++] = c;
        for (int a = 0; a < 4; ++a)
            for (int b = a + 1; b < 4; ++b)
                if (order[a] > order[b]) positive = !positive;
        const auto at = [&](int p, int q) { return vertex(cube, bits[order[p]], bits[order[q]]); };
        if (inside == 1) {
            add({at(0, 1), at(0, 2), at(0, 3)}, positive);
        } else if (inside == 3) {
            add({at(0, 3), at(1, 3), at(2, 3)}, positive);
        } else {
            add({at(0, 2), at(0, 3), at(1, 3)}, positive);
            add({at(0, 2), at(1, 3), at(1, 2)}, positive);
        }
    }

  private:
    std::uint32_t vertex(std::uint64_t cube, unsigned p, unsigned q) const {
        // Corners of one tetrahedron contain each other as sets of axes, so one is the start of the edge.
        const std::uint64_t edge = 8 * (cube + lattice_.step(p & q)) + (p ^ q);
        return static_cast<std::uint32_t>(std::lower_bound(edges_.begin(), edges_.end(), edge) -
                                          edges_.begin());
    }
    void add(Triangle t, bool positive) {
        if (!positive) std::swap(t[1], t[2]);
        out_.push_back(t);
    }

    const Lattice& lattice_;
    const std::vector<std::uint64_t>& edges_;
    std::vector<Triangle>& out_;
};

}  // namespace

Surface marchTetrahedra(const Distance& distance, const Box& box, double cell) {
    const Lattice lattice = sample(distance, box, cell);
    const auto edges = crossedEdges(lattice);
    Surface surface;
    surface.positions.reserve(edges.size());
    for (const std::uint64_t edge : edges) surface.positions.push_back(crossing(lattice, edge));
    TetrahedronCutter cutter(lattice, edges, surface.triangles);
    // The six ways from corner 0 to corner 7 along three axes; the even ones turn counterclockwise.
    constexpr std::array<std::array<unsigned, 3>, 6> kPaths = {
        {{1, 2, 4}, {2, 4, 1}, {4, 1, 2}, {2, 1, 4}, {1, 4, 2}, {4, 2, 1}}};
    forEachCube(lattice, [&](std::uint64_t cube) {
        for (unsigned path = 0; path < kPaths.size(); ++path) {
            const auto& axes = kPaths[path];
            cutter.cut(cube, {0, axes[0], axes[0] | axes[1], 7}, path < 3);
        }
    });
    return surface;
}

}  // namespace demolish::sculptor
