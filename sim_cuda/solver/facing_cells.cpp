// SPDX-License-Identifier: Apache-2.0
// Triangles of the outsides of two bodies, laid over each other where they face each other.
#include "sim_cuda/solver/facing_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace demolish {
namespace {

/// Cosine of the angle between outsides that face each other, at most; and the least area that counts, in
/// h^2.
constexpr double kFacing = -0.95, kLeastArea = 0.02;

struct Corners3 {
    Vec3<double> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

    void add(const Vec3<double>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    bool isNear(const Corners3& other, double gap) const {
        return low.x <= other.high.x + gap && other.low.x <= high.x + gap && low.y <= other.high.y + gap &&
               other.low.y <= high.y + gap && low.z <= other.high.z + gap && other.low.z <= high.z + gap;
    }
};

/// Of the outside of a cell, in the world.
struct OuterTriangle {
    uint32_t cell = 0;  ///< particle of the scene
    std::array<Vec3<double>, 3> corner;
    Vec3<double> normal;  ///< unit
    Corners3 box;
};

struct Outside {
    std::vector<OuterTriangle> triangles;
    Corners3 box;
};

Outside outsideOf(const BodyInstance& instance, uint32_t first) {
    Outside outside;
    const FractureGeometry& geometry = instance.body->geometry;
    const Quaternion& r = instance.rotation;
    const Quat<double> q = normalized(Quat<double>{r.x, r.y, r.z, r.w});
    const Vec3<double> at{instance.position.x, instance.position.y, instance.position.z};
    for (size_t k = 0; k + 2 < geometry.exterior_indices.size(); k += 3) {
        OuterTriangle triangle;
        for (size_t c = 0; c < 3; ++c) {
            const SurfaceVertex& vertex = geometry.exterior[geometry.exterior_indices[k + c]];
            triangle.cell = first + vertex.cell;
            triangle.corner[c] =
                at + rotate(q, Vec3<double>{vertex.position.x, vertex.position.y, vertex.position.z});
            triangle.box.add(triangle.corner[c]);
            outside.box.add(triangle.corner[c]);
        }
        const Vec3<double> across =
            cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
        const double twice = length(across);
        if (!(twice > 0)) continue;
        triangle.normal = (1 / twice) * across;
        outside.triangles.push_back(triangle);
    }
    return outside;
}

std::vector<const OuterTriangle*> nearTo(const Outside& outside, const Corners3& box, double gap) {
    std::vector<const OuterTriangle*> near;
    for (const OuterTriangle& triangle : outside.triangles)
        if (triangle.box.isNear(box, gap)) near.push_back(&triangle);
    return near;
}

using Axis = double Vec3<double>::*;

Axis longestOf(const Corners3& box) {
    const Vec3<double> size = box.high - box.low;
    if (size.x >= size.y && size.x >= size.z) return &Vec3<double>::x;
    return size.y >= size.z ? &Vec3<double>::y : &Vec3<double>::z;
}

/// Triangles, sorted along the axis on which they are spread farthest.
class SpreadTriangles {
  public:
    explicit SpreadTriangles(std::vector<const OuterTriangle*> triangles) : sorted_(std::move(triangles)) {
        Corners3 all;
        for (const OuterTriangle* t : sorted_) {
            all.add(t->box.low);
            all.add(t->box.high);
        }
        axis_ = longestOf(all);
        for (const OuterTriangle* t : sorted_)
            widest_ = std::max(widest_, t->box.high.*axis_ - t->box.low.*axis_);
        std::sort(sorted_.begin(), sorted_.end(), [&](const OuterTriangle* a, const OuterTriangle* b) {
            return a->box.low.*axis_ < b->box.low.*axis_;
        });
    }
    /// Those that may be near, in the order of their body.
    std::vector<const OuterTriangle*> about(const Corners3& box, double gap) const {
        const auto firstFrom = [&](double place) {
            return std::partition_point(sorted_.begin(), sorted_.end(),
                                        [&](const OuterTriangle* t) { return t->box.low.*axis_ < place; });
        };
        std::vector<const OuterTriangle*> near;
        const auto last = firstFrom(std::nextafter(box.high.*axis_ + gap, 1e300));
        for (auto at = firstFrom(box.low.*axis_ - gap - widest_); at != last; ++at)
            if ((*at)->box.isNear(box, gap)) near.push_back(*at);
        std::sort(near.begin(), near.end());
        return near;
    }

  private:
    std::vector<const OuterTriangle*> sorted_;
    Axis axis_ = &Vec3<double>::x;
    double widest_ = 0;  ///< m, along the axis
};

double areaOf(const std::vector<Vec3<double>>& polygon, const Vec3<double>& normal) {
    double twice = 0;
    for (size_t k = 2; k < polygon.size(); ++k)
        twice += dot(normal, cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]));
    return 0.5 * std::fabs(twice);
}

/// m^2: of b, laid on the plane of a, within a.
double sharedArea(const OuterTriangle& a, const OuterTriangle& b) {
    std::vector<Vec3<double>> polygon;
    for (const Vec3<double>& corner : b.corner)
        polygon.push_back(axpy(-dot(a.normal, corner - a.corner[0]), a.normal, corner));
    for (size_t side = 0; side < 3 && !polygon.empty(); ++side) {
        const Vec3<double> from = a.corner[side], along = a.corner[(side + 1) % 3] - from;
        const Vec3<double> inward = cross(a.normal, along);
        std::vector<Vec3<double>> inside;
        for (size_t k = 0; k < polygon.size(); ++k) {
            const Vec3<double>&p = polygon[k], &next = polygon[(k + 1) % polygon.size()];
            const double depth = dot(inward, p - from), depth_next = dot(inward, next - from);
            if (depth >= 0) inside.push_back(p);
            if ((depth >= 0) != (depth_next >= 0))
                inside.push_back(axpy(depth / (depth - depth_next), next - p, p));
        }
        polygon = std::move(inside);
    }
    return polygon.size() < 3 ? 0 : areaOf(polygon, a.normal);
}

/// m, along the normal of a.
double gapBetween(const OuterTriangle& a, const OuterTriangle& b) {
    const Vec3<double> middle = (1.0 / 3) * (b.corner[0] + b.corner[1] + b.corner[2]);
    return dot(a.normal, middle - a.corner[0]);
}

/// Of two that are near each other.
bool facesEachOther(const OuterTriangle& a, const OuterTriangle& b, double gap) {
    return dot(a.normal, b.normal) <= kFacing && std::fabs(gapBetween(a, b)) <= gap;
}

/// Of two cells, added up over what they share: area; times gap and normal.
struct Shared {
    double area = 0, gap = 0;
    Vec3<double> normal;
};
using SharedOf = std::map<std::pair<uint32_t, uint32_t>, Shared>;

void addShared(const Outside& a, const Outside& b, double gap, SharedOf& shared) {
    const SpreadTriangles of_b(nearTo(b, a.box, gap));
    for (const OuterTriangle* own : nearTo(a, b.box, gap))
        for (const OuterTriangle* other : of_b.about(own->box, gap)) {
            if (!facesEachOther(*own, *other, gap)) continue;
            const double area = sharedArea(*own, *other);
            if (!(area > 0)) continue;
            Shared& sum = shared[{own->cell, other->cell}];
            sum.area += area;
            sum.gap += area * gapBetween(*own, *other);
            sum.normal = axpy(area, own->normal, sum.normal);
        }
}

}  // namespace

std::vector<FacingCells> facingCells(const SceneSetup& setup, const SceneTables& tables,
                                     const FacingGap& gap_of) {
    std::vector<Outside> outside;
    uint32_t first = 0;
    for (const BodyInstance& instance : setup.bodies) {
        outside.push_back(outsideOf(instance, first));
        first += static_cast<uint32_t>(instance.body->particles.size());
    }
    SharedOf shared;  // by the cell of the lower body, which is the lower one
    for (uint32_t a = 0; a < tables.bodies; ++a)
        for (uint32_t b = a + 1; b < tables.bodies; ++b) {
            const double gap = gap_of(a, b);
            if (gap >= 0 && outside[a].box.isNear(outside[b].box, gap))
                addShared(outside[a], outside[b], gap, shared);
        }
    std::vector<FacingCells> cells;
    for (const auto& [ids, sum] : shared) {
        const double h = std::min(setup.bodies[tables.owner[ids.first]].body->spacing,
                                  setup.bodies[tables.owner[ids.second]].body->spacing);
        if (!(sum.area > kLeastArea * h * h)) continue;
        const double inverse = inverseSqrt(length2(sum.normal));
        cells.push_back({ids.first, ids.second, sum.area, sum.gap / sum.area, inverse * sum.normal});
    }
    return cells;
}

}  // namespace demolish
