// SPDX-License-Identifier: Apache-2.0
// How kernels see the points of the outside, and what is known of each in a frame.
#pragma once
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// The outside of a scene, static; see FractureGeometry.
struct OutsideMesh {
    Span<const OutsidePoint> points;
    Span<const MeshTriangle> triangles;
    Span<const uint32_t> corner_start, corner_next, corner_previous;
    Span<const float> corner_weight;  ///< of corner_next, the nearer the more; they sum to 1 round a point
    /// Of the part at each corner at rest: (unit normal that is seen from outside; twice its area, m^2).
    Span<const Vec4<float>> corner_part;
    Span<const uint32_t> crack_start;
    Span<const PointCrack> cracks;
    Span<const CrackEdge> edges;
};

/// What runs through a point: nothing, a crack inside one fragment, or the border of two.
enum class RimKind : uint8_t { kNone, kHairline, kApart };

/// A point's place in the lines of cracks of its kind.
struct RimLink {
    uint32_t next[2];   ///< points along the line, where there are two
    uint32_t smallest;  ///< cells of the smallest fragment that the line bounds here
    RimKind kind;
    uint8_t degree;  ///< how many lines leave the point; 255 for more
    uint8_t fixed;   ///< 1: of kind kApart at the last update already: shown, so that it never moves again
    uint8_t reserved;
};
static_assert(sizeof(RimLink) == 16);

/// The part of a shift that leaves the body its shape.
DEM_FN Vec3<float> alongOutside(const OutsidePoint& point, const Vec3<float>& shift) {
    const Vec3<float> axis = toVec3(point.axis);
    if (point.kind == SlideKind::kPlane) return axpy(-dot(shift, axis), axis, shift);
    if (point.kind == SlideKind::kEdge) return dot(shift, axis) * axis;
    return {};
}

DEM_FN Vec3<float> atMost(float limit, const Vec3<float>& shift) {
    const float squared = length2(shift);
    return squared > limit * limit ? (limit * inverseSqrt(squared)) * shift : shift;
}

}  // namespace demolish
