// SPDX-License-Identifier: Apache-2.0
// Edge collapse on indexed triangles with the fan of every vertex at hand.
#include "assets/models/editable_mesh.h"

#include <algorithm>
#include <iterator>

namespace demolish::sculptor {
namespace {

bool has(const Triangle& t, std::uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

double qualityOf(const std::array<Vec3, 3>& p) {
    const Vec3 a = p[1] - p[0], b = p[2] - p[1], c = p[0] - p[2];
    const double squares = dot(a, a) + dot(b, b) + dot(c, c);
    return squares > 0 ? 2 * std::sqrt(3.0) * length(cross(a, c)) / squares : 0;
}

}  // namespace

EditableMesh::EditableMesh(const Surface& surface)
    : positions_(surface.positions),
      triangles_(surface.triangles),
      alive_(surface.triangles.size(), true),
      fans_(surface.positions.size()),
      alive_count_(surface.triangles.size()) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (const std::uint32_t v : triangles_[t]) fans_[v].push_back(t);
}

std::vector<std::uint32_t> EditableMesh::neighbours(std::uint32_t vertex) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t t : fans_[vertex])
        for (const std::uint32_t v : triangles_[t])
            if (v != vertex) found.push_back(v);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool EditableMesh::keepsManifold(std::uint32_t a, std::uint32_t b) const {
    const auto around_a = neighbours(a), around_b = neighbours(b);
    std::vector<std::uint32_t> shared;
    std::set_intersection(around_a.begin(), around_a.end(), around_b.begin(), around_b.end(),
                          std::back_inserter(shared));
    if (shared.size() != 2) return false;
    // A vertex opposite the edge loses one triangle of its fan; three are the least a closed fan can have.
    for (const std::uint32_t v : shared)
        if (fans_[v].size() <= 3) return false;
    return around_a.size() + around_b.size() > 6;
}

bool EditableMesh::fanKeepsShape(std::uint32_t moved, std::uint32_t other, Vec3 p,
                                 const ShapeLimits& limits) const {
    for (const std::uint32_t index : fans_[moved]) {
        const Triangle& t = triangles_[index];
        if (has(t, other)) continue;
        std::array<Vec3, 3> before, after;
        for (int i = 0; i < 3; ++i) {
            before[i] = positions_[t[i]];
            after[i] = t[i] == moved ? p : before[i];
        }
        const Vec3 old_normal = cross(before[1] - before[0], before[2] - before[0]);
        const Vec3 new_normal = cross(after[1] - after[0], after[2] - after[0]);
        if (dot(old_normal, new_normal) < limits.turn_cosine * length(old_normal) * length(new_normal))
            return false;
        if (qualityOf(after) < std::min(limits.quality, qualityOf(before))) return false;
        if (dot(new_normal, new_normal) == 0) return false;
    }
    return true;
}

bool EditableMesh::keepsShape(std::uint32_t a, std::uint32_t b, Vec3 p, const ShapeLimits& limits) const {
    return fanKeepsShape(a, b, p, limits) && fanKeepsShape(b, a, p, limits);
}

void EditableMesh::collapse(std::uint32_t a, std::uint32_t b, Vec3 p) {
    positions_[a] = p;
    for (const std::uint32_t index : fans_[b]) {
        Triangle& t = triangles_[index];
        if (has(t, a)) {
            alive_[index] = false;
            --alive_count_;
            for (const std::uint32_t v : t)
                if (v != b) std::erase(fans_[v], index);
        } else {
            std::replace(t.begin(), t.end(), b, a);
            fans_[a].push_back(index);
        }
    }
    fans_[b].clear();
}

Surface EditableMesh::surface() const {
    Surface surface;
    std::vector<std::uint32_t> renumbered(positions_.size());
    for (std::uint32_t v = 0; v < positions_.size(); ++v) {
        if (!isAlive(v)) continue;
        renumbered[v] = static_cast<std::uint32_t>(surface.positions.size());
        surface.positions.push_back(positions_[v]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        if (alive_[t])
            surface.triangles.push_back(
                {renumbered[triangles_[t][0]], renumbered[triangles_[t][1]], renumbered[triangles_[t][2]]});
    return surface;
}

}  // namespace demolish::sculptor
