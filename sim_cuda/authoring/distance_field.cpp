// SPDX-License-Identifier: Apache-2.0
// Band splat, sweeps and sign of the distance grid, each parallel over layers that only their own task
// writes.
#include "sim_cuda/authoring/distance_field.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "sim_cuda/authoring/row_crossings.h"
#include "sim_cuda/authoring/slab_splat.h"

namespace demolish {
namespace {

/// Triangles by the slabs of layers that their band touches, in ascending order.
std::vector<std::vector<uint32_t>> trianglesBySlab(const TriangleMesh& mesh, const NodeFrame& frame) {
    std::vector<std::vector<uint32_t>> slabs(size_t((frame.nz + kSlabLayers - 1) / kSlabLayers));
    const double band = kBand * frame.step;
    for (uint32_t id = 0; id < mesh.triangles.size(); ++id) {
        const auto& t = mesh.triangles[id];
        const auto [low, high] =
            std::minmax({mesh.positions[t[0]].z, mesh.positions[t[1]].z, mesh.positions[t[2]].z});
        const IndexRange ks =
            nodesBetween(low - frame.origin.z - band, high - frame.origin.z + band, frame.step, frame.nz);
        if (ks.begin >= ks.end) continue;
        for (int s = ks.begin / kSlabLayers; s <= (ks.end - 1) / kSlabLayers; ++s)
            slabs[size_t(s)].push_back(id);
    }
    return slabs;
}

/// One grid axis: how many nodes, how far apart in the index, and the way from one to the next (m).
struct Axis {
    int count;
    ptrdiff_t stride;
    float x, y, z;
};
/// Layers follow each other along the first axis; the nodes of a layer lie along the other two.
struct SweepAxes {
    Axis along, row, column;
};

/// Takes over the nearest points of the previous layer (`source` is its index distance) where they are
/// nearer.
void sweepRow(const SweepAxes& axes, int layer, int r, ptrdiff_t source, float exact,
              std::vector<Nearest>& nearest) {
    const auto& [along, row, column] = axes;
    const ptrdiff_t first = layer * along.stride + r * row.stride;
    const int r_first = r > 0 ? -1 : 0, r_last = r + 1 < row.count ? 1 : 0;
    const float layer_f = float(layer), r_f = float(r);
    for (int c = 0; c < column.count; ++c) {
        const ptrdiff_t here = first + c * column.stride;
        Nearest& node = nearest[size_t(here)];
        if (node.squared <= exact) continue;
        const float c_f = float(c);
        const float x = layer_f * along.x + r_f * row.x + c_f * column.x;
        const float y = layer_f * along.y + r_f * row.y + c_f * column.y;
        const float z = layer_f * along.z + r_f * row.z + c_f * column.z;
        const int c_first = c > 0 ? -1 : 0, c_last = c + 1 < column.count ? 1 : 0;
        for (int dr = r_first; dr <= r_last; ++dr)
            for (int dc = c_first; dc <= c_last; ++dc) {
                const Nearest& from = nearest[size_t(here + source + dr * row.stride + dc * column.stride)];
                if (from.squared == std::numeric_limits<float>::infinity()) continue;
                const float dx = from.x - x, dy = from.y - y, dz = from.z - z;
                const float squared = dx * dx + dy * dy + dz * dz;
                if (squared < node.squared) node = {from.x, from.y, from.z, squared};
            }
    }
}

void sweepAll(const NodeFrame& frame, std::vector<Nearest>& nearest) {
    const float step = float(frame.step), exact = float(kBand * kBand) * step * step;
    const Axis x{frame.nx, 1, step, 0, 0}, y{frame.ny, frame.nx, 0, step, 0};
    const Axis z{frame.nz, ptrdiff_t(frame.nx) * frame.ny, 0, 0, step};
    for (const SweepAxes& axes : {SweepAxes{z, y, x}, SweepAxes{y, z, x}, SweepAxes{x, z, y}}) {
        const auto sweepLayer = [&](int layer, ptrdiff_t source) {
            tbb::parallel_for(tbb::blocked_range<int>(0, axes.row.count, 16), [&](const auto& rows) {
                for (int r = rows.begin(); r < rows.end(); ++r)
                    sweepRow(axes, layer, r, source, exact, nearest);
            });
        };
        for (int layer = 1; layer < axes.along.count; ++layer) sweepLayer(layer, -axes.along.stride);
        for (int layer = axes.along.count - 2; layer >= 0; --layer) sweepLayer(layer, axes.along.stride);
    }
}

}  // namespace

std::vector<float> signedDistances(const TriangleMesh& mesh, const MeshQueries& queries,
                                   const NodeFrame& frame) {
    std::vector<Nearest> nearest(frame.size());
    const auto slabs = trianglesBySlab(mesh, frame);
    RowCrossings crossings(frame);
    tbb::parallel_for(size_t(0), slabs.size(), [&](size_t s) {
        const IndexRange layers{int(s) * kSlabLayers, std::min(frame.nz, int(s + 1) * kSlabLayers)};
        SlabSplat splat(frame, layers, nearest);
        for (const uint32_t id : slabs[s]) {
            const auto& t = mesh.triangles[id];
            const std::array<Double3, 3> corners{mesh.positions[t[0]] - frame.origin,
                                                 mesh.positions[t[1]] - frame.origin,
                                                 mesh.positions[t[2]] - frame.origin};
            splat.add(corners);
            crossings.add(corners, layers.begin, layers.end);
        }
        crossings.finishLayers(layers.begin, layers.end, [&](int i, int j, int k) {
            return queries.windingNumber(frame.node(i, j, k));
        });
    });
    sweepAll(frame, nearest);
    std::vector<float> distance(frame.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, frame.size(), 1 << 14),
                      [&](const tbb::blocked_range<size_t>& range) {
                          for (size_t n = range.begin(); n < range.end(); ++n) {
                              const float unsigned_distance = std::sqrt(nearest[n].squared);
                              distance[n] = crossings.winding(n) > 0 ? -unsigned_distance : unsigned_distance;
                          }
                      });
    return distance;
}

}  // namespace demolish
