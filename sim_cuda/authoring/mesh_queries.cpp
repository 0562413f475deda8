// SPDX-License-Identifier: Apache-2.0
// Winding number and closest point on the triangle tree.
#include "sim_cuda/authoring/mesh_queries.h"

#include <algorithm>
#include <limits>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/planar_side.h"
#include "sim_cuda/authoring/point_triangle.h"
#include "sim_cuda/authoring/triangle_tree.h"

namespace demolish {

struct MeshQueries::Bvh {
    explicit Bvh(const TriangleMesh& mesh) : tree(mesh) {}
    TriangleTree tree;
};

namespace {

/// Ray in coordinates where it is the z axis through the origin: a shear and a choice of axes. All triangles
/// that share a vertex see the same bits of it, so an edge is passed on the same side by both its triangles.
class ShearedRay {
  public:
    ShearedRay(const Double3& origin, const Double3& direction) : origin_(origin) {
        const double size[3] = {std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
        main_ = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
        const Double3 d = turned(direction);
        step_ = {d.x, d.y, d.z};
        shear_x_ = d.x / d.z;
        shear_y_ = d.y / d.z;
    }
    Double3 seen(const Double3& p) const {
        const Double3 q = turned(p - origin_);
        return {q.x - shear_x_ * q.z, q.y - shear_y_ * q.z, q.z};
    }
    double forward() const { return step_.z > 0 ? 1 : -1; }

  private:
    /// Cyclic, so that handedness stays.
    Double3 turned(const Double3& v) const {
        return main_ == 0 ? Double3{v.y, v.z, v.x} : main_ == 1 ? Double3{v.z, v.x, v.y} : v;
    }
    Double3 origin_, step_;
    int main_ = 2;
    double shear_x_ = 0, shear_y_ = 0;
};

enum class Crossing { kNone, kOut, kIn, kGrazed };

Crossing crossingOf(const ShearedRay& ray, const std::array<Double3, 3>& corners) {
    const Double3 a = ray.seen(corners[0]), b = ray.seen(corners[1]), c = ray.seen(corners[2]);
    const double u = edgeSide(b.x, b.y, c.x, c.y), v = edgeSide(c.x, c.y, a.x, a.y),
                 w = edgeSide(a.x, a.y, b.x, b.y);
    const bool any_plus = u > 0 || v > 0 || w > 0, any_minus = u < 0 || v < 0 || w < 0;
    if (any_plus && any_minus) return Crossing::kNone;
    const double sum = u + v + w, depth = (u * a.z + v * b.z + w * c.z) * ray.forward();
    if (u == 0 || v == 0 || w == 0) {
        // Grazing behind the ray's start does no harm.
        const double f = ray.forward();
        return a.z * f < 0 && b.z * f < 0 && c.z * f < 0 ? Crossing::kNone : Crossing::kGrazed;
    }
    if ((sum > 0) != (depth > 0) || depth == 0) return Crossing::kNone;
    return (sum > 0) == (ray.forward() > 0) ? Crossing::kOut : Crossing::kIn;
}

/// Directions without relation to axes, diagonals or each other.
Double3 rayDirection(int attempt) {
    constexpr uint64_t kStream = 0x726179;
    if (attempt == 0) return {0.2837461, 0.1592653, 0.9455823};
    return normalized(hashRandomInCube(kStream, 0, uint64_t(attempt)) + Double3{1e-3, 2e-3, 3e-3});
}

/// Calls cross(triangle, direction) wherever a ray from the point leaves the solid (1) or enters it (-1), and
/// restart() before each ray: there is another one where the last grazed an edge.
template <typename Restart, typename Cross>
void traceRay(const TriangleTree& tree, const Double3& point, Restart&& restart, Cross&& cross) {
    if (!tree.boundsContain(point)) return;
    constexpr int kAttempts = 32;  // all graze only for a point on the surface, where any answer is right
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Double3 direction = rayDirection(attempt);
        const ShearedRay ray(point, direction);
        restart();
        const bool clean = tree.visitAlongRay(point, direction, kEndless,
                                              [&](const std::array<Double3, 3>& corners, uint32_t triangle) {
                                                  const Crossing crossing = crossingOf(ray, corners);
                                                  if (crossing == Crossing::kOut) cross(triangle, 1);
                                                  if (crossing == Crossing::kIn) cross(triangle, -1);
                                                  return crossing != Crossing::kGrazed;
                                              });
        if (clean) break;
    }
}

}  // namespace

MeshQueries::MeshQueries(const TriangleMesh& mesh) : bvh_(std::make_unique<Bvh>(mesh)) {}
MeshQueries::~MeshQueries() = default;
MeshQueries::MeshQueries(MeshQueries&&) noexcept = default;

const TriangleTree& MeshQueries::tree() const {
    return bvh_->tree;
}

std::vector<SurfaceCrossing> MeshQueries::crossings(const Double3& point) const {
    std::vector<SurfaceCrossing> crossings;
    traceRay(
        bvh_->tree, point, [&] { crossings.clear(); },
        [&](uint32_t triangle, int direction) {
            const bool is_known = bvh_->tree.repeats() &&
                                  std::any_of(crossings.begin(), crossings.end(),
                                              [&](const auto& other) { return other.triangle == triangle; });
            if (!is_known) crossings.push_back({triangle, direction});
        });
    return crossings;
}

int MeshQueries::windingNumber(const Double3& point) const {
    int winding = 0;
    if (bvh_->tree.repeats())
        for (const SurfaceCrossing& crossing : crossings(point)) winding += crossing.direction;
    else
        traceRay(
            bvh_->tree, point, [&] { winding = 0; }, [&](uint32_t, int direction) { winding += direction; });
    return winding;
}

ClosestPoint MeshQueries::closestPoint(const Double3& point, double bound) const {
    ClosestPoint best{point, std::numeric_limits<double>::infinity(), kNoTriangle};
    double best_squared = bound < 1e150 ? bound * bound : std::numeric_limits<double>::infinity();
    bvh_->tree.visitNearest(
        point, best_squared, [&](const std::array<Double3, 3>& corners, uint32_t triangle) {
            if (isFartherFromTriangle(point, corners[0], corners[1], corners[2], best_squared)) return;
            const Double3 candidate = closestOnTriangle(point, corners[0], corners[1], corners[2]);
            const double squared = lengthSquared(point - candidate);
            const bool nearer =
                squared < best_squared || (squared == best_squared && triangle < best.triangle);
            if (!nearer) return;
            best_squared = squared;
            best = {candidate, std::sqrt(squared), triangle};
        });
    return best;
}

}  // namespace demolish
