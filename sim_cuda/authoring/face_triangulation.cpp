// SPDX-License-Identifier: Apache-2.0
// Ear clipping; holes are first joined to the outline by bridges that cross nothing.
#include "sim_cuda/authoring/face_triangulation.h"

#include <algorithm>
#include <cmath>

namespace demolish {

namespace {

constexpr double kFlat = 1e-13;  // of the outline's box: collinear but for rounding

}  // namespace

const std::vector<std::array<uint32_t, 3>>& FaceTriangulation::triangulate(
    std::span<const PlanePoint> points, std::span<const uint32_t> loop_start) {
    points_ = points;
    triangles_.clear();
    outline_.clear();
    PlanePoint lower = points[0], upper = points[0];
    for (uint32_t p = loop_start[0]; p < loop_start[1]; ++p) {
        outline_.push_back(p);
        lower = {std::min(lower.x, points[p].x), std::min(lower.y, points[p].y)};
        upper = {std::max(upper.x, points[p].x), std::max(upper.y, points[p].y)};
    }
    const double width = std::max(upper.x - lower.x, upper.y - lower.y);
    tolerance_ = kFlat * width * width;
    for (size_t hole = 1; hole + 1 < loop_start.size(); ++hole)
        if (!bridgeHole(loop_start[hole], loop_start[hole + 1], loop_start))
            for (uint32_t p = loop_start[hole] + 2; p < loop_start[hole + 1]; ++p)  // negative, so it cancels
                triangles_.push_back({loop_start[hole], p - 1, p});
    clipEars();
    return triangles_;
}

/// Is the segment from `at` to `target` inside the solid next to `at`?
bool FaceTriangulation::isInWedge(uint32_t previous, uint32_t at, uint32_t next, uint32_t target) const {
    const PlanePoint &p = points_[at], &a = points_[previous], &b = points_[next], &q = points_[target];
    if (turn(a, p, b) >= 0) return turn(p, q, a) > 0 && turn(q, p, b) > 0;
    return !(turn(p, q, b) >= 0 && turn(q, p, a) >= 0);
}

bool FaceTriangulation::crossesLoops(uint32_t a, uint32_t b, std::span<const uint32_t> loop_start) const {
    const PlanePoint &p = points_[a], &q = points_[b];
    const auto crosses = [&](uint32_t c, uint32_t d) {
        if (c == a || c == b || d == a || d == b) return false;
        const PlanePoint &r = points_[c], &s = points_[d];
        const double rs_p = turn(r, s, p), rs_q = turn(r, s, q), pq_r = turn(p, q, r), pq_s = turn(p, q, s);
        return (rs_p >= 0) != (rs_q > 0) && (pq_r >= 0) != (pq_s > 0);
    };
    for (size_t k = 0; k < outline_.size(); ++k)
        if (crosses(outline_[k], outline_[(k + 1) % outline_.size()])) return true;
    for (size_t loop = 1; loop + 1 < loop_start.size(); ++loop)
        for (uint32_t p0 = loop_start[loop]; p0 < loop_start[loop + 1]; ++p0)
            if (crosses(p0, p0 + 1 < loop_start[loop + 1] ? p0 + 1 : loop_start[loop])) return true;
    return false;
}

/// Joins the hole to the outline by the shortest bridge that stays in the solid.
bool FaceTriangulation::bridgeHole(uint32_t begin, uint32_t end, std::span<const uint32_t> loop_start) {
    struct Bridge {
        double length;
        uint32_t hole, slot;
    };
    std::vector<Bridge> bridges;
    for (uint32_t hole = begin; hole < end; ++hole)
        for (uint32_t slot = 0; slot < outline_.size(); ++slot) {
            const PlanePoint &p = points_[hole], &q = points_[outline_[slot]];
            bridges.push_back({std::hypot(p.x - q.x, p.y - q.y), hole, slot});
        }
    std::stable_sort(bridges.begin(), bridges.end(),
                     [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
    const uint32_t n = uint32_t(outline_.size());
    for (const Bridge& bridge : bridges) {
        const uint32_t at = outline_[bridge.slot], hole = bridge.hole;
        const uint32_t before = hole > begin ? hole - 1 : end - 1, after = hole + 1 < end ? hole + 1 : begin;
        if (!isInWedge(outline_[(bridge.slot + n - 1) % n], at, outline_[(bridge.slot + 1) % n], hole))
            continue;
        if (!isInWedge(before, hole, after, at) || crossesLoops(hole, at, loop_start)) continue;
        std::vector<uint32_t> detour;
        for (uint32_t k = 0; k <= end - begin; ++k)
            detour.push_back(begin + (hole - begin + k) % (end - begin));
        detour.push_back(at);
        outline_.insert(outline_.begin() + bridge.slot + 1, detour.begin(), detour.end());
        return true;
    }
    return false;
}

void FaceTriangulation::refreshTurn(uint32_t node) {
    Node& n = nodes_[node];
    n.turn = turn(points_[nodes_[n.previous].point], points_[n.point], points_[nodes_[n.next].point]);
}

/// Patience 0: a proper ear; 1: may be flat or touch others; 2: anything, so that the clipping always ends.
bool FaceTriangulation::isEar(uint32_t node, int patience) const {
    if (patience == 2) return true;
    const Node &at = nodes_[node], &before = nodes_[at.previous], &after = nodes_[at.next];
    const double tolerance = patience == 0 ? tolerance_ : 0;
    if (patience == 0 ? at.turn <= tolerance : at.turn < 0) return false;
    const PlanePoint &a = points_[before.point], &b = points_[at.point], &c = points_[after.point];
    for (uint32_t other = after.next; other != at.previous; other = nodes_[other].next) {
        const Node& o = nodes_[other];
        if (o.turn > tolerance || o.point == before.point || o.point == at.point || o.point == after.point)
            continue;
        const PlanePoint& p = points_[o.point];
        const double ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
        if (patience == 0 ? (ab >= -tolerance && bc >= -tolerance && ca >= -tolerance)
                          : (ab > 0 && bc > 0 && ca > 0))
            return false;
    }
    return true;
}

void FaceTriangulation::clipEars() {
    const uint32_t n = uint32_t(outline_.size());
    nodes_.resize(n);
    for (uint32_t k = 0; k < n; ++k) nodes_[k] = {outline_[k], (k + n - 1) % n, (k + 1) % n, 0};
    for (uint32_t k = 0; k < n; ++k) refreshTurn(k);
    uint32_t at = 0, left = n, unsuccessful = 0;
    int patience = 0;
    while (left > 3) {
        if (!isEar(at, patience)) {
            at = nodes_[at].next;
            if (++unsuccessful == left) {
                ++patience;
                unsuccessful = 0;
            }
            continue;
        }
        const uint32_t before = nodes_[at].previous, after = nodes_[at].next;
        triangles_.push_back({nodes_[before].point, nodes_[at].point, nodes_[after].point});
        nodes_[before].next = after;
        nodes_[after].previous = before;
        refreshTurn(before);
        refreshTurn(after);
        at = nodes_[after].next;  // not the same corner again: fewer needles
        --left;
        patience = 0;
        unsuccessful = 0;
    }
    triangles_.push_back(
        {nodes_[nodes_[at].previous].point, nodes_[at].point, nodes_[nodes_[at].next].point});
}

}  // namespace demolish
