// SPDX-License-Identifier: Apache-2.0
// Trilinear signed distance and the list of nodes inside.
#include <cassert>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/distance_field.h"
#include "sim_cuda/authoring/mesh_checks.h"

namespace demolish {

struct DistanceGrid::Grid {
    NodeFrame frame;
    std::vector<float> distance;
    std::vector<Double3> inside;

    /// Where a point lies: the lower node of its cell, the fractions within it, and how far it is from the
    /// grid.
    struct Place {
        size_t node;
        double fx, fy, fz;
        double beyond;  // m, 0 within the grid
    };
    Place placeOf(const Double3& p) const {
        const Double3 local = (p - frame.origin) * (1 / frame.step);
        const Double3 last{double(frame.nx - 1), double(frame.ny - 1), double(frame.nz - 1)};
        const Double3 inner = maximum(minimum(local, last), {});
        const int i = std::min(int(inner.x), frame.nx - 2), j = std::min(int(inner.y), frame.ny - 2);
        const int k = std::min(int(inner.z), frame.nz - 2);
        return {frame.index(i, j, k), inner.x - i, inner.y - j, inner.z - k,
                length(local - inner) * frame.step};
    }

    /// Node values of the cell with lower node `n`, by pairs along x.
    struct Cell {
        double v[2][2][2];  // z, y, x
    };
    Cell cellAt(size_t n) const {
        Cell cell;
        const size_t row = size_t(frame.nx), layer = row * size_t(frame.ny);
        for (size_t k = 0; k < 2; ++k)
            for (size_t j = 0; j < 2; ++j)
                for (size_t i = 0; i < 2; ++i)
                    cell.v[k][j][i] = double(distance[n + k * layer + j * row + i]);
        return cell;
    }

    /// Octree descent: Morton order without sorting.
    void listInside(int x, int y, int z, int size) {
        if (x >= frame.nx || y >= frame.ny || z >= frame.nz) return;
        if (size == 1) {
            if (distance[frame.index(x, y, z)] < 0) inside.push_back(frame.node(x, y, z));
            return;
        }
        const int half = size / 2;
        for (int octant = 0; octant < 8; ++octant)
            listInside(x + (octant & 1 ? half : 0), y + (octant & 2 ? half : 0), z + (octant & 4 ? half : 0),
                       half);
    }
};

namespace {

double mix(double a, double b, double f) {
    return a + (b - a) * f;
}

/// One to two steps of margin, by irrational parts of the step: rows then miss vertices that sit on round
/// coordinates.
NodeFrame frameAround(const TriangleMesh& mesh, int nodes) {
    const Bounds bounds = boundsOf(mesh.positions);
    const Double3 extent = bounds.upper - bounds.lower;
    NodeFrame frame;
    frame.step = std::max({extent.x, extent.y, extent.z}) / (nodes - 1);
    frame.origin =
        bounds.lower - Double3{1.4142135623730951, 1.7320508075688772, 1.6180339887498949} * frame.step;
    const auto count = [&](double length_along) { return int(std::ceil(length_along / frame.step)) + 4; };
    frame.nx = count(extent.x);
    frame.ny = count(extent.y);
    frame.nz = count(extent.z);
    return frame;
}

}  // namespace

DistanceGrid::DistanceGrid(const TriangleMesh& mesh, const MeshQueries& queries, int nodes)
    : grid_(std::make_unique<Grid>()) {
    assert(nodes >= 2);
    grid_->frame = frameAround(mesh, nodes);
    grid_->distance = signedDistances(mesh, queries, grid_->frame);
    int size = 1;
    while (size < std::max({grid_->frame.nx, grid_->frame.ny, grid_->frame.nz})) size *= 2;
    grid_->listInside(0, 0, 0, size);
}
DistanceGrid::~DistanceGrid() = default;
DistanceGrid::DistanceGrid(DistanceGrid&&) noexcept = default;

double DistanceGrid::distance(const Double3& point) const {
    const Grid::Place at = grid_->placeOf(point);
    const auto [v] = grid_->cellAt(at.node);
    const double near = mix(mix(v[0][0][0], v[0][0][1], at.fx), mix(v[0][1][0], v[0][1][1], at.fx), at.fy);
    const double far = mix(mix(v[1][0][0], v[1][0][1], at.fx), mix(v[1][1][0], v[1][1][1], at.fx), at.fy);
    return mix(near, far, at.fz) + at.beyond;
}

Double3 DistanceGrid::gradient(const Double3& point) const {
    const Grid::Place at = grid_->placeOf(point);
    const auto cell = grid_->cellAt(at.node);
    const auto& v = cell.v;
    const auto along_x = [&](int k, int j) { return v[k][j][1] - v[k][j][0]; };
    const auto at_x = [&](int k, int j) { return mix(v[k][j][0], v[k][j][1], at.fx); };
    const double dx =
        mix(mix(along_x(0, 0), along_x(0, 1), at.fy), mix(along_x(1, 0), along_x(1, 1), at.fy), at.fz);
    const double dy = mix(at_x(0, 1) - at_x(0, 0), at_x(1, 1) - at_x(1, 0), at.fz);
    const double dz = mix(at_x(1, 0), at_x(1, 1), at.fy) - mix(at_x(0, 0), at_x(0, 1), at.fy);
    return Double3{dx, dy, dz} * (1 / grid_->frame.step);
}

const std::vector<Double3>& DistanceGrid::insideNodesInMortonOrder() const {
    return grid_->inside;
}
double DistanceGrid::nodeSpacing() const {
    return grid_->frame.step;
}

}  // namespace demolish
