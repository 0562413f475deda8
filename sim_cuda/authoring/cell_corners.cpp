// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/cell_corners.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/double3.h"

namespace demolish {
namespace {

/// Of the spacing: what a hull may lack in a direction that is looked at.
constexpr double kTolerance = 2e-3;

/// Unit vectors to the points of a grid on the faces of a cube, 386 of them. Square roots are all it takes,
/// so that they are the same everywhere.
std::vector<Double3> directions() {
    constexpr int kHalf = 4;
    std::vector<Double3> all;
    for (int x = -kHalf; x <= kHalf; ++x)
        for (int y = -kHalf; y <= kHalf; ++y)
            for (int z = -kHalf; z <= kHalf; ++z)
                if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == kHalf)
                    all.push_back(normalized({double(x), double(y), double(z)}));
    return all;
}

/// How far a set of points reaches in each direction, and which of them does.
struct Support {
    std::vector<double> reach;
    std::vector<uint32_t> point;
};
Support supportOf(const std::vector<Double3>& points, const std::vector<Double3>& directions) {
    Support support{std::vector<double>(directions.size(), -1e300), std::vector<uint32_t>(directions.size())};
    for (size_t d = 0; d < directions.size(); ++d)
        for (uint32_t p = 0; p < points.size(); ++p)
            if (const double reach = dot(points[p], directions[d]); reach > support.reach[d]) {
                support.reach[d] = reach;
                support.point[d] = p;
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
    for (auto& vertices : of_cell) {
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    return of_cell;
}

}  // namespace

/// One after the other: whichever point reaches farthest beyond those that are there.
std::vector<Double3> hullCorners(const std::vector<Double3>& points, double tolerance) {
    static const std::vector<Double3> kDirections = directions();
    const Support hull = supportOf(points, kDirections);
    std::vector<double> reached(kDirections.size(), -1e300);
    std::vector<Double3> corners;
    while (corners.size() < kMostCorners) {
        size_t worst = 0;
        for (size_t d = 1; d < reached.size(); ++d)
            if (hull.reach[d] - reached[d] > hull.reach[worst] - reached[worst]) worst = d;
        if (points.empty() || !(hull.reach[worst] - reached[worst] > tolerance)) break;
        const Double3 corner = points[hull.point[worst]];
        corners.push_back(corner);
        for (size_t d = 0; d < reached.size(); ++d)
            reached[d] = std::max(reached[d], dot(corner, kDirections[d]));
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
