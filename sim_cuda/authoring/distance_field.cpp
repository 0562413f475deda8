// SPDX-License-Identifier: Apache-2.0
// Band splat, sweeps and sign of the distance grid, each parallel over layers that only their own task
// writes.
#include "sim_cuda/authoring/distance_field.h"

#include <tbb/parallel_for.h>

#include <limits>

#include "sim_cuda/authoring/point_triangle.h"
#include "sim_cuda/authoring/row_crossings.h"

namespace demolish {
namespace {

constexpr double kBand =
    1.8;  // steps; above the diagonal of a grid cell, so every cell the surface meets is exact
constexpr int kSlabLayers = 4;

/// Nearest surface point known so far, relative to the grid's origin.
struct Nearest {
    float x = 0, y = 0, z = 0, squared = std::numeric_limits<float>::infinity();
};

struct IndexRange {
    int begin, end;
};
/// Nodes along one axis whose coordinate (relative to the origin) lies in [lower, upper].
IndexRange nodesBetween(double lower, double upper, double step, int count) {
    const double last = count - 1;
    return {int(std::clamp(std::ceil(lower / step), 0.0, double(count))),
            int(std::clamp(std::floor(upper / step), -1.0, last)) + 1};
}

/// One triangle relative to the grid's origin.
struct SplatTriangle {
    Double3 a, b, c, normal;  // unit normal, zero without area
    Double3 lower, upper;
    double per_normal_x;  // 0 where the plane is all but parallel to rows
    std::array<Double3, 3>
        out;  // from sides a b, b c, c a in the plane, hardly shorter than 1; zero of slivers
    SplatTriangle(const TriangleMesh& mesh, uint32_t id, const Double3& origin)
        : a(mesh.positions[mesh.triangles[id][0]] - origin),
          b(mesh.positions[mesh.triangles[id][1]] - origin),
          c(mesh.positions[mesh.triangles[id][2]] - origin),
          normal(normalized(cross(b - a, c - a))),
          lower(minimum(minimum(a, b), c)),
          upper(maximum(maximum(a, b), c)),
          per_normal_x(std::abs(normal.x) > 1e-6 ? 1 / normal.x : 0) {
        constexpr double kShorter = 1 - 1e-6, kSlender = 1e-6;  // rounding must not decide
        const Double3 ab = b - a, ac = c - a;
        if (!(lengthSquared(cross(ab, ac)) > kSlender * kSlender * lengthSquared(ab) * lengthSquared(ac)))
            return;
        out = {normalized(cross(ab, normal)) * kShorter, normalized(cross(c - b, normal)) * kShorter,
               normalized(cross(a - c, normal)) * kShorter};
    }
    /// m, of a point of the plane from the triangle at least.
    double beyondSides(const Double3& p) const {
        return std::max(std::max(dot(out[0], p - a), 0.0), std::max(dot(out[1], p - b), dot(out[2], p - c)));
    }
};

/// Part of a row (y, z) within `band` of the triangle's plane: long triangles would visit their whole box
/// otherwise.
IndexRange rowNearPlane(const SplatTriangle& t, double y, double z, double band, const NodeFrame& frame) {
    double lower = t.lower.x - band, upper = t.upper.x + band;
    const double rest = t.normal.y * (y - t.a.y) + t.normal.z * (z - t.a.z);
    if (t.per_normal_x != 0) {
        const double from = t.a.x + (-band - rest) * t.per_normal_x,
                     to = t.a.x + (band - rest) * t.per_normal_x;
        lower = std::max(lower, std::min(from, to) - 1e-9 * frame.step);
        upper = std::min(upper, std::max(from, to) + 1e-9 * frame.step);
    } else if (std::abs(rest) > band * 1.001 + 1e-6 * (std::abs(lower - t.a.x) + std::abs(upper - t.a.x))) {
        return {0, 0};
    }
    return nodesBetween(lower, upper, frame.step, frame.nx);
}

/// How far a coordinate lies outside of [lower, upper].
double beyond(double at, double lower, double upper) {
    return std::max({lower - at, at - upper, 0.0});
}

void splatTriangle(const SplatTriangle& t, const NodeFrame& frame, IndexRange layers,
                   std::vector<Nearest>& nearest) {
    const double band = kBand * frame.step;
    const IndexRange js = nodesBetween(t.lower.y - band, t.upper.y + band, frame.step, frame.ny);
    const IndexRange ks = nodesBetween(t.lower.z - band, t.upper.z + band, frame.step, frame.nz);
    for (int k = std::max(ks.begin, layers.begin); k < std::min(ks.end, layers.end); ++k)
        for (int j = js.begin; j < js.end; ++j) {
            const double y = j * frame.step, z = k * frame.step;
            const IndexRange is = rowNearPlane(t, y, z, band, frame);
            Nearest* row = nearest.data() + frame.index(0, j, k);
            const double off_y = beyond(y, t.lower.y, t.upper.y), off_z = beyond(z, t.lower.z, t.upper.z);
            const double off_row = off_y * off_y + off_z * off_z;
            for (int i = is.begin; i < is.end; ++i) {
                const Double3 p{i * frame.step, y, z};
                const double from_plane = dot(t.normal, p - t.a);
                if (from_plane * from_plane > double(row[i].squared)) continue;
                const double off_x = beyond(p.x, t.lower.x, t.upper.x);
                if (off_x * off_x + off_row > double(row[i].squared)) continue;
                const double off_sides = t.beyondSides(p);
                if (from_plane * from_plane + off_sides * off_sides > double(row[i].squared)) continue;
                const Double3 q = closestOnTriangle(p, t.a, t.b, t.c);
                const float squared = float(lengthSquared(p - q));
                if (squared < row[i].squared) row[i] = {float(q.x), float(q.y), float(q.z), squared};
            }
        }
}

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
        for (const uint32_t id : slabs[s]) {
            const SplatTriangle t(mesh, id, frame.origin);
            splatTriangle(t, frame, layers, nearest);
            crossings.add({t.a, t.b, t.c}, layers.begin, layers.end);
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
