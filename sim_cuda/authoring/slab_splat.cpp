// SPDX-License-Identifier: Apache-2.0
// Triangles reach the nodes of their band block by block, row by row; the same bits as if each asked all.
#include "sim_cuda/authoring/slab_splat.h"

#include <optional>

#include "sim_cuda/authoring/lanes.h"
#include "sim_cuda/authoring/point_triangle.h"

namespace demolish {
namespace {

constexpr double kEndlessReach = std::numeric_limits<double>::infinity();
constexpr double kRoom = 1e-6;  // of a step and of a reach: rounding must not decide

Double3 lowest(const std::array<Double3, 3>& corners) {
    return minimum(minimum(corners[0], corners[1]), corners[2]);
}
Double3 highest(const std::array<Double3, 3>& corners) {
    return maximum(maximum(corners[0], corners[1]), corners[2]);
}

IndexRange common(IndexRange a, IndexRange b) {
    return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// How far a coordinate lies outside of [lower, upper].
double beyond(double at, double lower, double upper) {
    return std::max({lower - at, at - upper, 0.0});
}

}  // namespace

/// One triangle relative to the grid's origin.
struct SplatTriangle {
    Double3 a, b, c, normal;  // unit normal, zero without area
    Double3 lower, upper;
    double per_normal_x;  // 0 where the plane is all but parallel to rows
    std::array<Double3, 3>
        out;  // from sides a b, b c, c a in the plane, hardly shorter than 1; zero of slivers
    explicit SplatTriangle(const std::array<Double3, 3>& corners)
        : a(corners[0]),
          b(corners[1]),
          c(corners[2]),
          normal(normalized(cross(b - a, c - a))),
          lower(lowest(corners)),
          upper(highest(corners)),
          per_normal_x(std::abs(normal.x) > 1e-6 ? 1 / normal.x : 0) {
        constexpr double kShorter = 1 - 1e-6, kSlender = 1e-6;  // rounding must not decide
        const Double3 ab = b - a, ac = c - a;
        if (!(lengthSquared(cross(ab, ac)) > kSlender * kSlender * lengthSquared(ab) * lengthSquared(ac)))
            return;
        out = {normalized(cross(ab, normal)) * kShorter, normalized(cross(c - b, normal)) * kShorter,
               normalized(cross(a - c, normal)) * kShorter};
    }
    /// Are all points of a box with this centre farther than `reach` beyond one side, or from the plane?
    bool isBeyond(const Double3& centre, const Double3& half, double reach) const {
        const auto spread = [&](const Double3& n) {
            return std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
        };
        return std::abs(dot(normal, centre - a)) - spread(normal) > reach ||
               dot(out[0], centre - a) - spread(out[0]) > reach ||
               dot(out[1], centre - b) - spread(out[1]) > reach ||
               dot(out[2], centre - c) - spread(out[2]) > reach;
    }
    /// Part of a row (y, z) within `band` of the plane: long triangles would visit their whole box otherwise.
    IndexRange rowNearPlane(double y, double z, double band, const NodeFrame& frame) const {
        double from = lower.x - band, to = upper.x + band;
        const double rest = normal.y * (y - a.y) + normal.z * (z - a.z);
        if (per_normal_x != 0) {
            const double one = a.x + (-band - rest) * per_normal_x,
                         other = a.x + (band - rest) * per_normal_x;
            from = std::max(from, std::min(one, other) - 1e-9 * frame.step);
            to = std::min(to, std::max(one, other) + 1e-9 * frame.step);
        } else if (std::abs(rest) > band * 1.001 + 1e-6 * (std::abs(from - a.x) + std::abs(to - a.x))) {
            return {0, 0};
        }
        return nodesBetween(from, to, frame.step, frame.nx);
    }
};

namespace {

/// What four nodes of a row that follow each other ask of a triangle: is it certainly no nearer than what
/// they know already?
class RowFilter {
  public:
    RowFilter(const SplatTriangle& t, double y, double z)
        : t_(t),
          plane_(acrossRow(t.normal, t.a, y, z)),
          sides_{acrossRow(t.out[0], t.a, y, z), acrossRow(t.out[1], t.b, y, z),
                 acrossRow(t.out[2], t.c, y, z)} {
        const double off_y = beyond(y, t.lower.y, t.upper.y), off_z = beyond(z, t.lower.z, t.upper.z);
        off_row_ = off_y * off_y + off_z * off_z;
    }
    /// All bits set in the lanes of nodes that have to look.
    LaneMask mayBeNearer(Lanes x, Lanes known) const {
        const Lanes none{};
        const Lanes off_x = larger(larger(t_.lower.x - x, x - t_.upper.x), none);
        const Lanes from_plane = plane_.at(x);
        const Lanes off_sides =
            larger(larger(sides_[0].at(x), none), larger(sides_[1].at(x), sides_[2].at(x)));
        return (off_x * off_x + off_row_ <= known) &
               (from_plane * from_plane + off_sides * off_sides <= known);
    }

  private:
    /// dot(direction, p - from) along a row, added up in the same order.
    struct AlongRow {
        double per_x, from_x, y_part, z_part;
        Lanes at(Lanes x) const { return per_x * (x - from_x) + y_part + z_part; }
    };
    static AlongRow acrossRow(const Double3& direction, const Double3& from, double y, double z) {
        return {direction.x, from.x, direction.y * (y - from.y), direction.z * (z - from.z)};
    }

    const SplatTriangle& t_;
    AlongRow plane_;
    std::array<AlongRow, 3> sides_;
    double off_row_;
};

}  // namespace

SlabSplat::SlabSplat(const NodeFrame& frame, IndexRange layers, std::vector<Nearest>& nearest)
    : frame_(frame),
      layers_(layers),
      nearest_(nearest),
      blocks_x_((frame.nx + kBlock - 1) / kBlock),
      blocks_y_((frame.ny + kBlock - 1) / kBlock),
      reach_(size_t(blocks_x_) * size_t(blocks_y_), kEndlessReach) {}

void SlabSplat::add(const std::array<Double3, 3>& corners) {
    constexpr int kLookAfter = 1024;
    const double band = kBand * frame_.step;
    const Double3 lower = lowest(corners), upper = highest(corners);
    const auto nodesNear = [&](double reach) -> Ranges {
        return {nodesBetween(lower.x - reach, upper.x + reach, frame_.step, frame_.nx),
                nodesBetween(lower.y - reach, upper.y + reach, frame_.step, frame_.ny),
                common(nodesBetween(lower.z - reach, upper.z + reach, frame_.step, frame_.nz), layers_)};
    };
    const Ranges all = nodesNear(band);
    if (all.x.isEmpty() || all.y.isEmpty() || all.z.isEmpty()) return;
    std::optional<SplatTriangle> triangle;
    for (int v = all.y.begin / kBlock; v <= (all.y.end - 1) / kBlock; ++v)
        for (int u = all.x.begin / kBlock; u <= (all.x.end - 1) / kBlock; ++u) {
            const double reach = reach_[size_t(v) * size_t(blocks_x_) + size_t(u)];
            const Ranges near = reach < band ? nodesNear(reach) : all;
            const Ranges nodes{common(near.x, {u * kBlock, (u + 1) * kBlock}),
                               common(near.y, {v * kBlock, (v + 1) * kBlock}), near.z};
            if (nodes.x.isEmpty() || nodes.y.isEmpty() || nodes.z.isEmpty()) continue;
            if (!triangle) triangle.emplace(corners);
            splatBlock(*triangle, nodes, reach);
        }
    if (++since_look_ < kLookAfter) return;
    since_look_ = 0;
    lookAtBlocks();
}

void SlabSplat::splatBlock(const SplatTriangle& t, const Ranges& nodes, double reach) {
    const double band = std::min(reach, kBand * frame_.step);
    const Double3 first = Double3{double(nodes.x.begin), double(nodes.y.begin), double(nodes.z.begin)};
    const Double3 last = Double3{double(nodes.x.end - 1), double(nodes.y.end - 1), double(nodes.z.end - 1)};
    const Double3 middle = (first + last) * (frame_.step / 2), half = (last - first) * (frame_.step / 2);
    if (t.isBeyond(middle, half, reach)) return;
    const bool is_known = reach < kEndlessReach;
    for (int k = nodes.z.begin; k < nodes.z.end; ++k)
        for (int j = nodes.y.begin; j < nodes.y.end; ++j) {
            const double y = j * frame_.step, z = k * frame_.step;
            if (is_known && t.isBeyond({middle.x, y, z}, {half.x, 0, 0}, reach)) continue;
            const IndexRange row = common(t.rowNearPlane(y, z, band, frame_), nodes.x);
            if (!row.isEmpty()) splatRow(t, row, j, k);
        }
}

void SlabSplat::splatRow(const SplatTriangle& t, IndexRange nodes, int j, int k) {
    const double y = j * frame_.step, z = k * frame_.step;
    Nearest* row = nearest_.data() + frame_.index(0, j, k);
    const RowFilter filter(t, y, z);
    for (int i = nodes.begin; i < nodes.end; i += kLanes) {
        Lanes x{}, known{};
        for (int lane = 0; lane < kLanes; ++lane) {
            x[lane] = (i + lane) * frame_.step;
            known[lane] = i + lane < nodes.end ? double(row[i + lane].squared) : -1;
        }
        const LaneMask looks = filter.mayBeNearer(x, known);
        if ((looks[0] | looks[1] | looks[2] | looks[3]) == 0) continue;
        for (int lane = 0; lane < kLanes; ++lane) {
            if (looks[lane] == 0) continue;
            const Double3 p{x[lane], y, z}, q = closestOnTriangle(p, t.a, t.b, t.c);
            const float squared = float(lengthSquared(p - q));
            Nearest& node = row[i + lane];
            if (squared < node.squared) node = {float(q.x), float(q.y), float(q.z), squared};
        }
    }
}

void SlabSplat::lookAtBlocks() {
    for (int v = 0; v < blocks_y_; ++v)
        for (int u = 0; u < blocks_x_; ++u) {
            const IndexRange xs = common({u * kBlock, (u + 1) * kBlock}, {0, frame_.nx});
            const IndexRange ys = common({v * kBlock, (v + 1) * kBlock}, {0, frame_.ny});
            float farthest = 0;
            for (int k = layers_.begin; k < layers_.end; ++k)
                for (int j = ys.begin; j < ys.end; ++j)
                    for (int i = xs.begin; i < xs.end; ++i)
                        farthest = std::max(farthest, nearest_[frame_.index(i, j, k)].squared);
            reach_[size_t(v) * size_t(blocks_x_) + size_t(u)] =
                std::sqrt(double(farthest)) * (1 + kRoom) + kRoom * frame_.step;
        }
}

}  // namespace demolish
