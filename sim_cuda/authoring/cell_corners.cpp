// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/cell_corners.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "sim_cuda/authoring/double3.h"

namespace demolish {
namespace {

/// Of the spacing: what a hull may lack in a direction that is looked at.
constexpr double kTolerance = 2e-3;

/// Unit vectors to the points of a grid on the faces of a cube. Square roots are all it takes, so that they
/// are the same everywhere. By coordinate, so that several are looked at at once.
constexpr size_t kDirections = 386;
struct Directions {
    std::array<double, kDirections> x, y, z;

    Directions() {
        constexpr int kHalf = 4;
        size_t d = 0;
        for (int i = -kHalf; i <= kHalf; ++i)
            for (int j = -kHalf; j <= kHalf; ++j)
                for (int k = -kHalf; k <= kHalf; ++k) {
                    if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != kHalf) continue;
                    const Double3 unit = normalized({double(i), double(j), double(k)});
                    x[d] = unit.x, y[d] = unit.y, z[d] = unit.z;
                    ++d;
                }
    }
    double along(size_t d, const Double3& p) const { return p.x * x[d] + p.y * y[d] + p.z * z[d]; }
};

/// How far a set of points reaches in each direction, and which of them does.
struct Support {
    std::array<double, kDirections> reach;
    std::array<uint64_t, kDirections> point;
};
Support supportOf(const std::vector<Double3>& points, const Directions& directions) {
    Support support;
    support.reach.fill(-1e300);
    support.point.fill(0);
    for (uint64_t p = 0; p < points.size(); ++p) {
        const Double3 at = points[p];
        for (size_t d = 0; d < kDirections; ++d) {
            const double reach = directions.along(d, at);
            const bool is_farther = reach > support.reach[d];
            support.reach[d] = is_farther ? reach : support.reach[d];
            support.point[d] = is_farther ? p : support.point[d];
        }
    }
    return support;
}

/// Which vertices each cell has, each once, ascending.
std::vector<std::vector<uint32_t>> verticesOfCells(const CellComplex& complex) {
    std::vector<std::vector<uint32_t>> of_cell(complex.seeds.size());
    for (const ExteriorPiece& piece : complex.pieces)
        for (uint32_t k = 0; k < piece.count; ++k)
            of_cell[piece.cell].push_back(complex.exterior_loop[piece.first + k]);
    for (const ComplexFace& face : complex.faces) {
        const uint32_t first = complex.loop_start[face.first_loop],
                       last = complex.loop_start[face.first_loop + face.loop_count];
        for (const uint32_t cell : {face.cell_a, face.cell_b})
            of_cell[cell].insert(of_cell[cell].end(), complex.loop_vertices.begin() + first,
                                 complex.loop_vertices.begin() + last);
    }
    tbb::parallel_for(size_t{0}, of_cell.size(), [&](size_t cell) {
        auto& vertices = of_cell[cell];
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    });
    return of_cell;
}

}  // namespace

/// One after the other: whichever point reaches farthest beyond those that are there.
std::vector<Double3> hullCorners(const std::vector<Double3>& points, double tolerance) {
    static const Directions directions;
    const Support hull = supportOf(points, directions);
    std::array<double, kDirections> reached;
    reached.fill(-1e300);
    std::vector<Double3> corners;
    while (corners.size() < kMostCorners) {
        size_t worst = 0;
        for (size_t d = 1; d < kDirections; ++d)
            if (hull.reach[d] - reached[d] > hull.reach[worst] - reached[worst]) worst = d;
        if (points.empty() || !(hull.reach[worst] - reached[worst] > tolerance)) break;
        const Double3 corner = points[hull.point[worst]];
        corners.push_back(corner);
        for (size_t d = 0; d < kDirections; ++d)
            reached[d] = std::max(reached[d], directions.along(d, corner));
    }
    return corners;
}

CellCorners cellCorners(const CellComplex& complex, double spacing) {
    const auto vertices = verticesOfCells(complex);
    std::vector<std::vector<Double3>> of_cell(vertices.size());
    tbb::parallel_for(size_t{0}, vertices.size(), [&](size_t cell) {
        std::vector<Double3> points;
        points.reserve(vertices[cell].size());
        for (const uint32_t v : vertices[cell])
            points.push_back(complex.vertices[v].position - complex.seeds[cell]);
        of_cell[cell] = hullCorners(points, kTolerance * spacing);
    });
    CellCorners corners;
    corners.start.push_back(0);
    for (const auto& own : of_cell) {
        corners.from_seed.insert(corners.from_seed.end(), own.begin(), own.end());
        corners.start.push_back(static_cast<uint32_t>(corners.from_seed.size()));
    }
    return corners;
}

}  // namespace demolish
