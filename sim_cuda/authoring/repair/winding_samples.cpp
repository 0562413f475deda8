// SPDX-License-Identifier: Apache-2.0
// The points of a grid, off its middle so that no wall of a model drawn on a grid meets them.
#include "sim_cuda/authoring/repair/winding_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/repair/winding_number.h"
#include "sim_cuda/authoring/row_crossings.h"

namespace demolish {
namespace {

constexpr int kPointsAlong = 32;  // of a cube
constexpr size_t kEnoughInside = 4000;
constexpr int kSlabs = 4;  // of layers, each of which looks at all triangles

struct SampleGrid {
    Bounds bounds;
    std::array<int, 3> count{};

    SampleGrid(const TriangleMesh& mesh, int along) : bounds(boundsOf(mesh.positions)) {
        const Double3 size = bounds.size();
        const double cell = std::cbrt(size.x * size.y * size.z) / along;
        const auto cells = [&](double side) { return int(std::clamp(side / cell, 3.0, 4.0 * along)); };
        count = {cells(size.x), cells(size.y), cells(size.z)};
    }
    size_t size() const { return size_t(count[0]) * size_t(count[1]) * size_t(count[2]); }
    Double3 point(size_t number) const {
        const size_t nx = size_t(count[0]), ny = size_t(count[1]);
        const Double3 size = bounds.size();
        return bounds.lower + Double3{(double(number % nx) + 0.517) / count[0] * size.x,
                                      (double(number / nx % ny) + 0.483) / count[1] * size.y,
                                      (double(number / nx / ny) + 0.509) / count[2] * size.z};
    }
    /// Sides of what each point stands for, m.
    Double3 cell() const {
        const Double3 size = bounds.size();
        return {size.x / count[0], size.y / count[1], size.z / count[2]};
    }
    double cellVolume() const {
        const Double3 size = bounds.size();
        return size.x * size.y * size.z / double(this->size());
    }
};

/// Through rows of the grid, in whose own coordinates its points are the whole numbers. Only rows that graze
/// an edge need a tree.
std::vector<int> windingsOn(const SampleGrid& grid, const TriangleMesh& mesh) {
    const NodeFrame frame{{}, 1, grid.count[0], grid.count[1], grid.count[2]};
    RowCrossings crossings(frame);
    const Double3 origin = grid.point(0), cell = grid.cell();
    std::vector<Double3> placed(mesh.positions.size());
    tbb::parallel_for(size_t(0), placed.size(), [&](size_t v) {
        const Double3& p = mesh.positions[v];
        placed[v] = {(p.x - origin.x) / cell.x, (p.y - origin.y) / cell.y, (p.z - origin.z) / cell.z};
    });
    tbb::parallel_for(0, kSlabs, [&](int slab) {
        const int begin = slab * frame.nz / kSlabs, end = (slab + 1) * frame.nz / kSlabs;
        for (const auto& [a, b, c] : mesh.triangles)
            crossings.add({placed[a], placed[b], placed[c]}, begin, end);
    });
    std::optional<MeshQueries> queries;
    crossings.finishLayers(0, frame.nz, [&](int i, int j, int k) {
        if (!queries) queries.emplace(mesh);
        return queries->windingNumber(grid.point(frame.index(i, j, k)));
    });
    std::vector<int> winding(grid.size());
    for (size_t i = 0; i < winding.size(); ++i) winding[i] = crossings.winding(i);
    return winding;
}

WindingSamples sampled(const SampleGrid& grid, const TriangleMesh& mesh) {
    const std::vector<int> winding = windingsOn(grid, mesh);
    WindingSamples samples;
    for (size_t i = 0; i < winding.size(); ++i) {
        samples.inside += winding[i] > 0;
        samples.negative += winding[i] < 0;
        if (winding[i] <= 1) continue;
        samples.doubled += size_t(winding[i] - 1);
        samples.doubled_points.push_back(grid.point(i));
    }
    samples.volume = double(samples.inside) * grid.cellVolume();
    return samples;
}

}  // namespace

WindingSamples sampleWinding(const TriangleMesh& mesh) {
    WindingSamples samples = sampled(SampleGrid(mesh, kPointsAlong), mesh);
    if (samples.inside < kEnoughInside) samples = sampled(SampleGrid(mesh, 2 * kPointsAlong), mesh);
    return samples;
}

double windingDifference(const TriangleMesh& closed, const TriangleMesh& caps) {
    const SampleGrid grid(closed, kPointsAlong);
    const std::vector<int> exact = windingsOn(grid, closed);
    const WindingNumber of_caps(caps);
    std::vector<char> differs(grid.size());
    tbb::parallel_for(size_t(0), grid.size(), [&](size_t i) {
        differs[i] = (exact[i] > 0) != (exact[i] - of_caps.at(grid.point(i)) > 0.5);
    });
    size_t inside = 0, different = 0;
    for (size_t i = 0; i < exact.size(); ++i) {
        inside += exact[i] > 0;
        different += differs[i] != 0;
    }
    return inside > 0 ? double(different) / double(inside) : 1;
}

}  // namespace demolish
