// SPDX-License-Identifier: Apache-2.0
// Bounding-box tree over the triangles of a mesh: the walk behind ray and nearest-point queries.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/lanes.h"

namespace demolish {

struct TreeBox {
    Double3 lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};
    void add(const Double3& p) {
        lower = minimum(lower, p);
        upper = maximum(upper, p);
    }
    void add(const TreeBox& other) {
        lower = minimum(lower, other.lower);
        upper = maximum(upper, other.upper);
    }
    /// m^2, half of the surface; 0 when nothing was added.
    double halfArea() const {
        const Double3 d = upper - lower;
        return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
    }
    bool contains(const Double3& p) const {
        return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y && p.z >= lower.z &&
               p.z <= upper.z;
    }
};

/// Four boxes that are asked at once.
struct FourBoxes {
    std::array<Lanes, 3> lower, upper;  // x, y, z

    void set(int lane, const TreeBox& box) {
        lower[0][lane] = box.lower.x, lower[1][lane] = box.lower.y, lower[2][lane] = box.lower.z;
        upper[0][lane] = box.upper.x, upper[1][lane] = box.upper.y, upper[2][lane] = box.upper.z;
    }
    /// m^2, 0 inside.
    Lanes distanceSquared(const Double3& p) const {
        const Lanes x = larger(larger(lower[0] - p.x, p.x - upper[0]), Lanes{}),
                    y = larger(larger(lower[1] - p.y, p.y - upper[1]), Lanes{}),
                    z = larger(larger(lower[2] - p.z, p.z - upper[2]), Lanes{});
        return x * x + y * y + z * z;
    }
    /// All bits set in the lanes of boxes that the line from `origin` may meet within `reach`. `inverse` is
    /// 1 / direction, no component of which is 0.
    LaneMask metBy(const Double3& origin, const Double3& inverse, double reach) const {
        const Lanes ax = (lower[0] - origin.x) * inverse.x, bx = (upper[0] - origin.x) * inverse.x,
                    ay = (lower[1] - origin.y) * inverse.y, by = (upper[1] - origin.y) * inverse.y,
                    az = (lower[2] - origin.z) * inverse.z, bz = (upper[2] - origin.z) * inverse.z;
        const Lanes enter =
                        larger(larger(smaller(ax, bx), smaller(ay, by)), larger(smaller(az, bz), Lanes{})),
                    leave = smaller(smaller(larger(ax, bx), larger(ay, by)),
                                    smaller(larger(az, bz), Lanes{} + reach));
        return enter <= leave;
    }
};

/// Copies the corners of the triangles, so the mesh need not outlive it. Long triangles that lie askew, whose
/// boxes are mostly empty, are in several leaves, each with the box of a part of it.
class TriangleTree {
  public:
    using Corners = std::array<Double3, 3>;
    explicit TriangleTree(const TriangleMesh& mesh);

    /// May a walk visit a triangle more than once?
    bool repeats() const { return triangles_.size() > triangle_count_; }

    /// Boxes are widened by rounding, so a point outside is certainly outside the mesh.
    bool boundsContain(const Double3& p) const { return bounds_.contains(p); }

    /// Calls visit(corners, triangle) for every triangle that the half line may meet within `reach` (lengths
    /// of `direction`; the visitor may lower it), until visit returns false; then so does this.
    template <typename Visit>
    bool visitAlongRay(const Double3& origin, const Double3& direction, const double& reach,
                       Visit&& visit) const;

    /// Calls visit(corners, triangle) near ones first, for all that may be as near as `bound_squared` (m^2),
    /// which the visitor lowers as it finds nearer ones.
    template <typename Visit>
    void visitNearest(const Double3& point, const double& bound_squared, Visit&& visit) const;

  private:
    /// A run of triangles, or a node; none of both: a lane that is not in use.
    struct Child {
        uint32_t first = 0;  ///< of its triangles, or the node
        uint32_t count = 0;  ///< of triangles
    };
    struct Node {
        FourBoxes boxes;
        std::array<Child, kLanes> children;
        int size = 0;  ///< lanes in use
    };
    struct Builder;
    static constexpr int kMaxDepth = 32;                               // of nodes
    static constexpr int kMostWaiting = (kLanes - 1) * kMaxDepth + 1;  // children yet to be looked at

    TreeBox bounds_;
    std::vector<Node> nodes_;
    std::vector<Corners> corners_;     // in tree order
    std::vector<uint32_t> triangles_;  // mesh ids in tree order
    size_t triangle_count_;            // of the mesh
};

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

template <typename Visit>
bool TriangleTree::visitAlongRay(const Double3& origin, const Double3& direction, const double& reach,
                                 Visit&& visit) const {
    const Double3 inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
    Child stack[kMostWaiting];
    int waiting = 0;
    stack[waiting++] = {};
    while (waiting > 0) {
        const Child child = stack[--waiting];
        for (uint32_t i = child.first; i < child.first + child.count; ++i)
            if (!visit(corners_[i], triangles_[i])) return false;
        if (child.count > 0) continue;
        const Node& node = nodes_[child.first];
        const LaneMask met = node.boxes.metBy(origin, inverse, reach);
        for (int lane = node.size - 1; lane >= 0; --lane)
            if (met[lane] != 0) stack[waiting++] = node.children[size_t(lane)];
    }
    return true;
}

template <typename Visit>
void TriangleTree::visitNearest(const Double3& point, const double& bound_squared, Visit&& visit) const {
    std::pair<double, Child> stack[kMostWaiting];
    int waiting = 0;
    stack[waiting++] = {0, {}};
    while (waiting > 0) {
        const auto [distance, child] = stack[--waiting];
        if (distance > bound_squared) continue;
        for (uint32_t i = child.first; i < child.first + child.count; ++i) visit(corners_[i], triangles_[i]);
        if (child.count > 0) continue;
        const Node& node = nodes_[child.first];
        const Lanes distances = node.boxes.distanceSquared(point);
        const int below = waiting;
        for (int lane = 0; lane < node.size; ++lane) {
            if (distances[lane] > bound_squared) continue;
            int place = waiting++;  // farther ones wait below
            for (; place > below && stack[place - 1].first < distances[lane]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {distances[lane], node.children[size_t(lane)]};
        }
    }
}

}  // namespace demolish
