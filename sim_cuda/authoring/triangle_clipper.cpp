// SPDX-License-Identifier: Apache-2.0
// Sutherland-Hodgman with labels: a new corner's key says which mesh side or which neighbour met which plane.
#include "sim_cuda/authoring/triangle_clipper.h"

#include <algorithm>

namespace demolish {

namespace {

constexpr size_t kLinearFlood = 48;  // up to so many cells a scan is quicker than a hash set

/// True: the cell was new and has been put in.
bool insertInto(std::vector<uint32_t>& set, uint32_t cell) {
    const size_t mask = set.size() - 1;
    size_t slot = (cell * 2654435761u) & mask;
    while (set[slot] != kNoCell) {
        if (set[slot] == cell) return false;
        slot = (slot + 1) & mask;
    }
    set[slot] = cell;
    return true;
}

}  // namespace

void TriangleClipper::startFlood(uint32_t triangle, const std::array<uint32_t, 3>& owners) {
    triangle_ = triangle;
    flood_.clear();
    visited_.clear();
    for (const uint32_t owner : owners) visit(owner);
}

void TriangleClipper::visit(uint32_t cell) {
    if (flood_.size() < kLinearFlood) {
        if (std::find(flood_.begin(), flood_.end(), cell) == flood_.end()) flood_.push_back(cell);
        return;
    }
    if (visited_.size() < 4 * flood_.size()) {
        size_t size = 256;
        while (size < 8 * flood_.size()) size *= 2;
        visited_.assign(size, kNoCell);
        for (const uint32_t known : flood_) insertInto(visited_, known);
    }
    if (insertInto(visited_, cell)) flood_.push_back(cell);
}

void TriangleClipper::loadTriangle() {
    const auto& corners = space_.mesh.triangles[triangle_];
    polygon_.clear();
    for (uint32_t k = 0; k < 3; ++k)
        polygon_.push_back({meshKey(corners[k]), space_.mesh.positions[corners[k]],
                            Double3{double(k == 0), double(k == 1), double(k == 2)}, k, kNoCell, 0});
}

void TriangleClipper::cutByCell(uint32_t id) {
    const VoronoiCell& cell = cells_[id];
    const Double3& seed = space_.seeds[id];
    const auto farthest = [&] {
        double most = 0;
        for (const Corner& corner : polygon_) most = std::max(most, lengthSquared(corner.position - seed));
        return most;
    };
    double reach = farthest();
    for (uint32_t face = 0; face < cell.seed_faces && polygon_.size() >= 3; ++face) {
        const uint32_t neighbour = cell.neighbours[face];
        // Faces come by distance: beyond twice the polygon's reach no plane can meet it.
        if (lengthSquared(space_.seeds[neighbour] - seed) > 4.000001 * reach) break;
        if (cutByPlane(id, neighbour)) reach = farthest();
    }
    if (polygon_.size() < 3) return;
    for (const Corner& corner : polygon_)
        if (corner.across != kNoCell) visit(corner.across);
}

bool TriangleClipper::cutByPlane(uint32_t cell, uint32_t neighbour) {
    const Double3 &i = space_.seeds[cell], &j = space_.seeds[neighbour];
    bool is_cut = false;
    for (Corner& corner : polygon_) {
        corner.side = nearerTo(j, i, corner.position);
        is_cut |= corner.side > 0;
    }
    if (!is_cut) return false;
    cut_.clear();
    for (size_t k = 0; k < polygon_.size(); ++k) {
        const Corner &from = polygon_[k], &to = polygon_[k + 1 < polygon_.size() ? k + 1 : 0];
        if (from.side <= 0) {
            cut_.push_back(from);
            if (to.side > 0) {  // leaves: from here on along the plane
                cut_.push_back(crossing(from, cell, neighbour));
                cut_.back().mesh_side = kNoSide;
                cut_.back().across = neighbour;
            }
        } else if (to.side <= 0) {  // comes back on the way it was on
            cut_.push_back(crossing(from, cell, neighbour));
            cut_.back().mesh_side = from.mesh_side;
            cut_.back().across = from.across;
        }
    }
    std::swap(polygon_, cut_);
    return true;
}

TriangleClipper::Corner TriangleClipper::crossing(const Corner& from, uint32_t cell,
                                                  uint32_t neighbour) const {
    Corner corner{};
    if (from.mesh_side != kNoSide) {
        const uint32_t edge = space_.edges.of_triangle[triangle_][from.mesh_side];
        corner.key = edgeKey(edge, cell, neighbour);
        const double share = edgeParameter(space_, edge, corner.key.ids[1], corner.key.ids[2]);
        const auto& t = space_.mesh.triangles[triangle_];
        const bool is_forward = t[from.mesh_side] == space_.edges.ends[edge][0];
        const double at_start = is_forward ? 1 - share : share, at_end = is_forward ? share : 1 - share;
        std::array<double, 3> b{};
        b[from.mesh_side] = at_start;
        b[(from.mesh_side + 1) % 3] = at_end;
        corner.barycentrics = {b[0], b[1], b[2]};
    } else {
        corner.key = triangleKey(triangle_, cell, from.across, neighbour);
        const auto& ids = corner.key.ids;
        corner.barycentrics = triangleBarycentrics(space_, triangle_, ids[1], ids[2], ids[3]);
    }
    corner.position = positionOf(space_, corner.key);
    return corner;
}

}  // namespace demolish
