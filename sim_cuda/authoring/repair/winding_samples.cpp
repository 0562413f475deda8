// SPDX-License-Identifier: Apache-2.0
// The points of a grid, off its middle so that no wall of a model drawn on a grid meets them.
#include "sim_cuda/authoring/repair/winding_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/repair/winding_number.h"

namespace demolish {
namespace {

constexpr int kPointsAlong = 32;  // of a cube
constexpr size_t kEnoughInside = 4000;

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
    double cellVolume() const {
        const Double3 size = bounds.size();
        return size.x * size.y * size.z / double(this->size());
    }
};

std::vector<int> windingsOn(const SampleGrid& grid, const MeshQueries& queries) {
    std::vector<int> winding(grid.size());
    tbb::parallel_for(size_t(0), winding.size(),
                      [&](size_t i) { winding[i] = queries.windingNumber(grid.point(i)); });
    return winding;
}

WindingSamples sampled(const SampleGrid& grid, const MeshQueries& queries) {
    const std::vector<int> winding = windingsOn(grid, queries);
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
    const MeshQueries queries(mesh);
    WindingSamples samples = sampled(SampleGrid(mesh, kPointsAlong), queries);
    if (samples.inside < kEnoughInside) samples = sampled(SampleGrid(mesh, 2 * kPointsAlong), queries);
    return samples;
}

double windingDifference(const TriangleMesh& closed, const TriangleMesh& raw) {
    const SampleGrid grid(closed, kPointsAlong);
    const std::vector<int> exact = windingsOn(grid, MeshQueries(closed));
    const WindingNumber winding(raw);
    std::vector<char> differs(grid.size());
    tbb::parallel_for(size_t(0), grid.size(),
                      [&](size_t i) { differs[i] = (exact[i] > 0) != (winding.at(grid.point(i)) > 0.5); });
    size_t inside = 0, different = 0;
    for (size_t i = 0; i < exact.size(); ++i) {
        inside += exact[i] > 0;
        different += differs[i] != 0;
    }
    return inside > 0 ? double(different) / double(inside) : 1;
}

}  // namespace demolish
