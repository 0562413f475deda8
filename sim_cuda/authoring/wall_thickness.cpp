// SPDX-License-Identifier: Apache-2.0
// Rays from the surface straight inwards.
#include "sim_cuda/api/authoring.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "sim_cuda/authoring/triangle_tree.h"

namespace demolish {
namespace {

/// Along a unit direction to the plane of the triangle, m; infinite where the ray passes it by.
double distanceAlong(const Double3& origin, const Double3& direction, const TriangleTree::Corners& t) {
    const Double3 u = t[1] - t[0], v = t[2] - t[0], p = cross(direction, v), s = origin - t[0];
    const double det = dot(u, p), a = dot(s, p) / det, b = dot(direction, cross(s, u)) / det;
    const bool meets = a >= 0 && b >= 0 && a + b <= 1;  // false for NaN
    return meets ? dot(v, cross(s, u)) / det : std::numeric_limits<double>::infinity();
}

}  // namespace

double thinWall(const SolidMesh& solid, double share) {
    constexpr size_t kRays = 4000;
    constexpr uint64_t kSeed = 1, kStream = 0x77616c6c;
    const TriangleMesh& mesh = solid.mesh();
    const TriangleTree& tree = solid.queries().tree();
    std::vector<double> area_up_to;
    for (const auto& k : mesh.triangles) {
        const Double3& a = mesh.positions[k[0]];
        const double twice = length(cross(mesh.positions[k[1]] - a, mesh.positions[k[2]] - a));
        area_up_to.push_back((area_up_to.empty() ? 0 : area_up_to.back()) + twice);
    }
    const double start = 1e-7 * length(solid.info().bounds_max - solid.info().bounds_min);
    std::vector<double> walls(kRays);
    tbb::parallel_for(size_t(0), kRays, [&](size_t ray) {
        const double at = (double(ray) + 0.5) / kRays * area_up_to.back();
        const size_t t =
            size_t(std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, at) - area_up_to.begin());
        const auto& k = mesh.triangles[t];
        const Double3 &a = mesh.positions[k[0]], &b = mesh.positions[k[1]], &c = mesh.positions[k[2]];
        const double root = std::sqrt(hashRandom(kSeed, kStream, 2 * ray)),
                     along = hashRandom(kSeed, kStream, 2 * ray + 1);
        const Double3 point = a * (1 - root) + b * (root * (1 - along)) + c * (root * along);
        // a little askew, since the tree's walk divides by each of its coordinates
        const Double3 inwards = normalized(normalized(cross(b - a, c - a)) * -1 + Double3{1e-5, 2e-5, 3e-5});
        double nearest = std::numeric_limits<double>::infinity();
        tree.visitAlongRay(point, inwards, nearest, [&](const TriangleTree::Corners& corners, uint32_t) {
            const double distance = distanceAlong(point, inwards, corners);
            if (distance > start) nearest = std::min(nearest, distance);
            return true;
        });
        walls[ray] = nearest;
    });
    const auto thin = walls.begin() + std::ptrdiff_t(share * double(kRays));
    std::nth_element(walls.begin(), thin, walls.end());
    return *thin;
}

}  // namespace demolish
