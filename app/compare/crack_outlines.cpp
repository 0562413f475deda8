// SPDX-License-Identifier: Apache-2.0
#include "app/compare/crack_outlines.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace demolish {
namespace {

class Outlines {
  public:
    Outlines(const FractureGeometry& geometry, std::span<const SurfaceVertex> outside,
             std::span<const uint32_t> fragment, std::span<const uint32_t> size)
        : geometry_(geometry) {
        for (const CrackEdge& edge : geometry.crack_edges) {
            const uint32_t a = fragment[edge.cell_a], b = fragment[edge.cell_b];
            const uint32_t u = geometry.exterior_home[edge.vertex_0].point,
                           v = geometry.exterior_home[edge.vertex_1].point;
            if (a == b || u == v) continue;
            all_[u].insert(v);
            all_[v].insert(u);
            place_[u] = placeOf(outside[edge.vertex_0]);
            place_[v] = placeOf(outside[edge.vertex_1]);
            if (std::min(size[a], size[b]) < kLargePiece) continue;
            large_[u].insert(v);
            large_[v].insert(u);
        }
    }
    std::vector<Line> lines() {
        std::vector<Line> lines;
        for (const bool through : {false, true})  // from ends and junctions first
            for (const auto& [u, others] : large_)
                if (goesOn(u) == through)
                    for (const uint32_t v : others)
                        if (!done_.contains({u, v})) lines.push_back(walk(u, v));
        return lines;
    }

  private:
    static glm::dvec3 placeOf(const SurfaceVertex& vertex) {
        return {vertex.position.x, vertex.position.y, vertex.position.z};
    }
    LineCorner cornerAt(uint32_t p) const {
        const Float3& normal = geometry_.points[p].normal;
        return {place_.at(p), {normal.x, normal.y, normal.z}};
    }
    bool goesOn(uint32_t p) const {
        return all_.at(p).size() == 2 && geometry_.points[p].kind == SlideKind::kPlane;
    }
    Line walk(uint32_t u, uint32_t v) {
        Line line{cornerAt(u)};
        for (uint32_t before = u, now = v;;) {
            done_.insert({before, now});
            done_.insert({now, before});
            line.push_back(cornerAt(now));
            if (!goesOn(now)) return line;
            const auto& others = all_.at(now);
            const uint32_t next = *others.begin() == before ? *others.rbegin() : *others.begin();
            if (!large_.at(now).contains(next) || done_.contains({now, next})) return line;
            before = now;
            now = next;
        }
    }

    const FractureGeometry& geometry_;
    std::map<uint32_t, std::set<uint32_t>> all_, large_;
    std::map<uint32_t, glm::dvec3> place_;
    std::set<std::pair<uint32_t, uint32_t>> done_;
};

}  // namespace

std::vector<Line> crackOutlines(const FractureGeometry& geometry, std::span<const SurfaceVertex> outside,
                                std::span<const uint32_t> fragment, std::span<const uint32_t> size) {
    return Outlines(geometry, outside, fragment, size).lines();
}

}  // namespace demolish
