// SPDX-License-Identifier: Apache-2.0
// Exact and fast questions to a closed mesh: what is inside, how far is the surface (geometry.md 1).
#pragma once
#include <memory>
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

class TriangleTree;

inline constexpr uint32_t kNoTriangle = 0xffffffffu;

/// Where a ray from a point passes the surface.
struct SurfaceCrossing {
    uint32_t triangle;
    int direction;  ///< 1 out of the solid, -1 into it
};

struct ClosestPoint {
    Double3 point;
    double distance = 0;  ///< m, unsigned
    uint32_t triangle = 0;
};

/// Triangle BVH. Queries are const and may run on any number of threads.
class MeshQueries {
  public:
    explicit MeshQueries(const TriangleMesh& mesh);
    ~MeshQueries();
    MeshQueries(MeshQueries&&) noexcept;

    /// Integer winding number by a signed ray: 1 inside, 0 outside a simple closed mesh. Exact for points in
    /// general position; the direction is re-drawn (deterministically) when the ray grazes an edge.
    int windingNumber(const Double3& point) const;
    /// What windingNumber() sums up, each triangle once: of several closed parts in one mesh, each part's own
    /// crossings sum up to its winding number.
    std::vector<SurfaceCrossing> crossings(const Double3& point) const;
    /// Closest surface point; `bound` limits the search (m): when nothing is that near, the distance is
    /// infinite and the triangle kNoTriangle. Of equally near triangles the lowest id.
    ClosestPoint closestPoint(const Double3& point, double bound = 1e300) const;

    const TriangleTree& tree() const;

  private:
    struct Bvh;
    std::unique_ptr<Bvh> bvh_;
};

/// Dense signed distance, negative inside, trilinear; `nodes` on the longest side.
class DistanceGrid {
  public:
    DistanceGrid(const TriangleMesh& mesh, const MeshQueries& queries, int nodes = 96);
    ~DistanceGrid();
    DistanceGrid(DistanceGrid&&) noexcept;

    double distance(const Double3& point) const;   ///< m
    Double3 gradient(const Double3& point) const;  ///< not normalised
    /// Centres of nodes with negative distance in Morton order (cached: the slider asks again and again).
    const std::vector<Double3>& insideNodesInMortonOrder() const;
    double nodeSpacing() const;

  private:
    struct Grid;
    std::unique_ptr<Grid> grid_;
};

}  // namespace demolish
