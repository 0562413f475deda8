// SPDX-License-Identifier: Apache-2.0
// Cutting a convex polyhedron: vertices beyond the plane go, the border of the gap is joined to the plane.
#include "sim_cuda/authoring/convex_cell.h"

#include "sim_cuda/authoring/cell_complex.h"

namespace demolish {

void ConvexCell::reset(double half_side) {
    planes_.clear();
    vertices_.clear();
    for (int side = 0; side < 6; ++side) {
        const double sign = side % 2 == 0 ? 1 : -1;
        Plane plane{{}, half_side, kNoCell};
        (side < 2 ? plane.normal.x : side < 4 ? plane.normal.y : plane.normal.z) = sign;
        planes_.push_back(plane);
    }
    for (uint16_t corner = 0; corner < 8; ++corner) {
        const uint16_t x = corner & 1, y = uint16_t(2 + ((corner >> 1) & 1)), z = uint16_t(4 + (corner >> 2));
        const bool is_mirrored = ((corner & 1) + ((corner >> 1) & 1) + (corner >> 2)) % 2 == 1;
        vertices_.push_back(is_mirrored ? makeVertex(x, z, y) : makeVertex(x, y, z));
    }
    reach_ = most_reach_ = half_side * std::sqrt(3.0);
}

ConvexCell::Vertex ConvexCell::makeVertex(uint16_t a, uint16_t b, uint16_t c) const {
    const Plane &p = planes_[a], &q = planes_[b], &r = planes_[c];
    const Double3 qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal),
                  pq = cross(p.normal, q.normal);
    const double scale = 1 / dot(p.normal, qr);
    return {{a, b, c}, (qr * p.offset + rp * q.offset + pq * r.offset) * scale};
}

void ConvexCell::collectBorder(const std::array<uint16_t, 3>& removed) {
    for (int side = 0; side < 3; ++side) {
        const uint16_t from = removed[size_t(side)], to = removed[size_t((side + 1) % 3)];
        bool is_inner = false;
        for (size_t e = 0; e < border_.size() && !is_inner; ++e)
            if (border_[e][0] == to && border_[e][1] == from) {
                border_[e] = border_.back();
                border_.pop_back();
                is_inner = true;
            }
        if (!is_inner) border_.push_back({from, to});
    }
}

void ConvexCell::cut(const Double3& towards, uint32_t neighbour) {
    const double offset = 0.5 * lengthSquared(towards);
    border_.clear();
    size_t kept = 0;
    for (size_t v = 0; v < vertices_.size(); ++v) {
        if (dot(towards, vertices_[v].position) > offset) {
            collectBorder(vertices_[v].planes);
        } else {
            if (kept != v) vertices_[kept] = vertices_[v];
            ++kept;
        }
    }
    if (kept == vertices_.size()) return;
    vertices_.resize(kept);
    const uint16_t plane = uint16_t(planes_.size());
    planes_.push_back({towards, offset, neighbour});
    for (const auto& edge : border_) vertices_.push_back(makeVertex(edge[0], edge[1], plane));
    double farthest = 0;
    for (const Vertex& vertex : vertices_) farthest = std::max(farthest, lengthSquared(vertex.position));
    reach_ = std::min(std::sqrt(farthest), most_reach_);
}

}  // namespace demolish
