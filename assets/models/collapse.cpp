// SPDX-License-Identifier: Apache-2.0
// The priority queue around EditableMesh.
#include "assets/models/collapse.h"

#include <queue>
#include <stdexcept>
#include <string>

#include "assets/models/editable_mesh.h"
#include "assets/models/quadric.h"

namespace demolish::sculptor {
namespace {

/// One edge (a < b) as it was when both ends had these versions.
struct Candidate {
    double cost = 0;
    std::uint32_t a = 0, b = 0, version_a = 0, version_b = 0;
    Vec3 target;
};

/// Orders the queue: cheapest on top, then by vertex numbers, so that no tie is left to the heap.
struct Dearer {
    bool operator()(const Candidate& l, const Candidate& r) const {
        if (l.cost != r.cost) return l.cost > r.cost;
        if (l.a != r.a) return l.a > r.a;
        return l.b > r.b;
    }
};

class Decimator {
  public:
    Decimator(const Surface& surface, const std::function<double(Vec3)>& weight)
        : mesh_(surface), quadrics_(surface.positions.size()), versions_(surface.positions.size()) {
        for (const Triangle& t : surface.triangles) {
            const Vec3 area_normal = areaNormal(surface, t);
            const auto& p = surface.positions;
            const Vec3 centre = (1.0 / 3) * (p[t[0]] + p[t[1]] + p[t[2]]);
            const Quadric plane =
                Quadric::plane(normalized(area_normal), p[t[0]], weight(centre) * length(area_normal));
            for (const std::uint32_t v : t) quadrics_[v] = quadrics_[v] + plane;
        }
    }

    Surface run(std::size_t target) {
        ShapeLimits limits;
        while (mesh_.triangleCount() > target) {
            const std::size_t before = mesh_.triangleCount();
            fill();
            drain(target, limits);
            if (before - mesh_.triangleCount() > before / 200) continue;
            limits.turn_cosine *= 0.7;
            limits.quality *= 0.7;
            if (limits.quality < 1e-3)
                throw std::runtime_error("the surface cannot be collapsed below " +
                                         std::to_string(mesh_.triangleCount()) + " triangles");
        }
        return mesh_.surface();
    }

  private:
    void push(std::uint32_t u, std::uint32_t v) {
        const std::uint32_t a = std::min(u, v), b = std::max(u, v);
        const Quadric sum = quadrics_[a] + quadrics_[b];
        const Vec3 pa = mesh_.position(a), pb = mesh_.position(b);
        const Vec3 target = sum.minimum(0.5 * (pa + pb));
        // The length term, too small to matter on curved ground, makes flat ground collapse evenly.
        const double trace = sum.xx + sum.yy + sum.zz;
        const double cost = std::abs(sum.at(target)) + 1e-5 * trace * dot(pb - pa, pb - pa);
        queue_.push({cost, a, b, versions_[a], versions_[b], target});
    }

    void fill() {
        for (std::uint32_t a = 0; a < mesh_.vertexCount(); ++a)
            if (mesh_.isAlive(a))
                for (const std::uint32_t b : mesh_.neighbours(a))
                    if (b > a) push(a, b);
    }

    void drain(std::size_t target, const ShapeLimits& limits) {
        while (!queue_.empty()) {
            const Candidate c = queue_.top();
            queue_.pop();
            if (mesh_.triangleCount() <= target) continue;
            if (versions_[c.a] != c.version_a || versions_[c.b] != c.version_b) continue;
            if (!mesh_.keepsManifold(c.a, c.b) || !mesh_.keepsShape(c.a, c.b, c.target, limits)) continue;
            mesh_.collapse(c.a, c.b, c.target);
            quadrics_[c.a] = quadrics_[c.a] + quadrics_[c.b];
            ++versions_[c.a];
            ++versions_[c.b];
            for (const std::uint32_t v : mesh_.neighbours(c.a)) push(c.a, v);
        }
    }

    EditableMesh mesh_;
    std::vector<Quadric> quadrics_;
    std::vector<std::uint32_t> versions_;  ///< counts the moves of each vertex; an older candidate is stale
    std::priority_queue<Candidate, std::vector<Candidate>, Dearer> queue_;
};

}  // namespace

Surface collapseTo(const Surface& surface, std::size_t triangles, const std::function<double(Vec3)>& weight) {
    if (triangles % 2 != 0 || triangles < 4)
        throw std::runtime_error("a closed surface needs an even number of triangles, 4 at least");
    if (triangles > surface.triangles.size())
        throw std::runtime_error("asked for " + std::to_string(triangles) +
                                 " triangles, but the grid gives only " +
                                 std::to_string(surface.triangles.size()) + "; make it finer");
    return Decimator(surface, weight).run(triangles);
}

}  // namespace demolish::sculptor
