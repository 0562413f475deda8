// SPDX-License-Identifier: Apache-2.0
// Tracing arcs to loops, giving holes to the loops around them, measuring and triangulating the parts.
#include "sim_cuda/authoring/face_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

namespace {

constexpr size_t kNoLoop = std::numeric_limits<size_t>::max();

double signedArea(std::span<const PlanePoint> loop) {
    double twice = 0;
    for (size_t k = 2; k < loop.size(); ++k) twice += turn(loop[0], loop[k - 1], loop[k]);
    return 0.5 * twice;
}

bool contains(std::span<const PlanePoint> loop, const PlanePoint& p) {
    bool is_inside = false;
    for (size_t k = 0, before = loop.size() - 1; k < loop.size(); before = k++) {
        const PlanePoint &a = loop[before], &b = loop[k];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            is_inside = !is_inside;
    }
    return is_inside;
}

}  // namespace

void FaceLoops::clear() {
    ids_.clear();
    start_.assign(1, 0);
}

void FaceLoops::addLoop(std::span<const uint32_t> vertex_ids) {
    ids_.insert(ids_.end(), vertex_ids.begin(), vertex_ids.end());
    start_.push_back(uint32_t(ids_.size()));
}

/// Takes the way since the last visit of `id` out of the path, as a loop.
void FaceLoops::closeLoop(uint32_t id) {
    const auto since = std::find(path_.begin(), path_.end(), id);
    if (since == path_.end()) return;
    if (path_.end() - since >= 3) addLoop({since, path_.end()});  // there and back bounds nothing
    path_.erase(since, path_.end());
}

bool FaceLoops::trace(std::vector<FaceArc>& arcs) {
    std::sort(arcs.begin(), arcs.end(), [](const FaceArc& a, const FaceArc& b) {
        return a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    is_used_.assign(arcs.size(), 0);
    path_.clear();
    const size_t ids_before = ids_.size(), loops_before = start_.size();
    for (size_t first = 0; first < arcs.size(); ++first) {
        for (size_t arc = first; !is_used_[arc];) {
            is_used_[arc] = 1;
            path_.push_back(arcs[arc].from);
            const uint32_t at = arcs[arc].to;
            arc = size_t(std::lower_bound(arcs.begin(), arcs.end(), at,
                                          [](const FaceArc& a, uint32_t from) { return a.from < from; }) -
                         arcs.begin());
            const bool is_crossroads = arc + 1 < arcs.size() && arcs[arc + 1].from == at;
            if (is_crossroads || at == arcs[first].from) closeLoop(at);
            if (path_.empty()) break;
            while (arc < arcs.size() && arcs[arc].from == at && is_used_[arc]) ++arc;
            if (arc == arcs.size() || arcs[arc].from != at) {
                ids_.resize(ids_before);
                start_.resize(loops_before);
                return false;
            }
        }
    }
    return true;
}

void FaceLoops::project(uint32_t cell_a, uint32_t cell_b) {
    const Double3 &a = seeds_[cell_a], &b = seeds_[cell_b];
    const Double3 normal = normalized(b - a);
    const Double3 helper = std::abs(normal.x) < 0.6 ? Double3{1, 0, 0} : Double3{0, 1, 0};
    axis_x_ = normalized(cross(helper, normal));
    axis_y_ = cross(normal, axis_x_);
    origin_ = vertices_[ids_[0]].position;
    points_.resize(ids_.size());
    for (size_t k = 0; k < ids_.size(); ++k) {
        const Double3 p = vertices_[ids_[k]].position - origin_;
        points_[k] = {dot(p, axis_x_), dot(p, axis_y_)};
    }
    areas_.clear();
    for (size_t loop = 0; loop + 1 < start_.size(); ++loop)
        areas_.push_back(
            signedArea(std::span(points_).subspan(start_[loop], start_[loop + 1] - start_[loop])));
}

/// The smallest counter-clockwise loop around a clockwise one.
size_t FaceLoops::outerLoopAround(size_t hole) const {
    size_t best = kNoLoop;
    for (size_t loop = 0; loop < areas_.size(); ++loop) {
        if (areas_[loop] < -areas_[hole] || (best != kNoLoop && areas_[best] <= areas_[loop])) continue;
        if (contains(std::span(points_).subspan(start_[loop], start_[loop + 1] - start_[loop]),
                     points_[start_[hole]]))
            best = loop;
    }
    return best;
}

void FaceLoops::emit(uint32_t cell_a, uint32_t cell_b, FaceArrays& out) {
    if (ids_.empty()) return;
    project(cell_a, cell_b);
    around_.assign(areas_.size(), kNoLoop);
    if (areas_.size() > 1)
        for (size_t loop = 0; loop < areas_.size(); ++loop)
            if (areas_[loop] < 0) around_[loop] = outerLoopAround(loop);
    for (size_t outer = 0; outer < areas_.size(); ++outer) {
        if (around_[outer] != kNoLoop) continue;
        part_.assign(1, outer);
        for (size_t hole = 0; hole < areas_.size(); ++hole)
            if (around_[hole] == outer) part_.push_back(hole);
        emitPart(cell_a, cell_b, part_, out);
    }
}

/// Voronoi polygons are convex: all corners of kind D.
bool FaceLoops::isConvex(std::span<const size_t> loops) const {
    return loops.size() == 1 && std::all_of(part_ids_.begin(), part_ids_.end(), [&](uint32_t id) {
               return vertices_[id].key.kind == VertexKind::kInterior;
           });
}

void FaceLoops::emitPart(uint32_t cell_a, uint32_t cell_b, std::span<const size_t> loops, FaceArrays& out) {
    ComplexFace face;
    face.cell_a = cell_a;
    face.cell_b = cell_b;
    face.first_loop = uint32_t(out.loop_end.size());
    face.loop_count = uint32_t(loops.size());
    face.first_triangle = uint32_t(out.triangles.size());
    part_ids_.clear();
    part_points_.clear();
    part_start_.assign(1, 0);
    for (const size_t loop : loops) {
        part_ids_.insert(part_ids_.end(), ids_.begin() + start_[loop], ids_.begin() + start_[loop + 1]);
        part_points_.insert(part_points_.end(), points_.begin() + start_[loop],
                            points_.begin() + start_[loop + 1]);
        part_start_.push_back(uint32_t(part_ids_.size()));
        out.loop_vertices.insert(out.loop_vertices.end(), ids_.begin() + start_[loop],
                                 ids_.begin() + start_[loop + 1]);
        out.loop_end.push_back(uint32_t(out.loop_vertices.size()));
    }
    if (isConvex(loops)) {
        for (size_t k = 2; k < part_ids_.size(); ++k)
            out.triangles.push_back({part_ids_[0], part_ids_[k - 1], part_ids_[k]});
    } else {
        for (const auto& t : triangulation_.triangulate(part_points_, part_start_))
            out.triangles.push_back({part_ids_[t[0]], part_ids_[t[1]], part_ids_[t[2]]});
    }
    measure(face);
    face.triangle_count = uint32_t(out.triangles.size()) - face.first_triangle;
    out.faces.push_back(face);
}

/// Area and centroid by the loops, so that they do not depend on the triangles.
void FaceLoops::measure(ComplexFace& face) const {
    const PlanePoint& base = part_points_[0];
    double twice = 0, moment_x = 0, moment_y = 0, mean_x = 0, mean_y = 0, extent = 0;
    for (size_t loop = 0; loop + 1 < part_start_.size(); ++loop)
        for (uint32_t k = part_start_[loop]; k < part_start_[loop + 1]; ++k) {
            const PlanePoint& p = part_points_[k];
            const PlanePoint& q = part_points_[k + 1 < part_start_[loop + 1] ? k + 1 : part_start_[loop]];
            const double area = turn(base, p, q);
            twice += area;
            moment_x += area * (p.x + q.x - 2 * base.x);
            moment_y += area * (p.y + q.y - 2 * base.y);
            mean_x += p.x / double(part_points_.size());
            mean_y += p.y / double(part_points_.size());
            extent = std::max({extent, std::abs(p.x - base.x), std::abs(p.y - base.y)});
        }
    face.area = 0.5 * twice;
    PlanePoint centre{mean_x, mean_y};  // of a sliver: rounding would throw the centroid far out
    if (std::abs(twice) > 1e-10 * extent * extent)
        centre = {base.x + moment_x / (3 * twice), base.y + moment_y / (3 * twice)};
    face.centroid = origin_ + axis_x_ * centre.x + axis_y_ * centre.y;
}

}  // namespace demolish
