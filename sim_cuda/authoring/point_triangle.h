// SPDX-License-Identifier: Apache-2.0
// Nearest point of one triangle: shared by the tree queries and the distance grid.
#pragma once
#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// Nearest point to `p` on segment a b.
inline Double3 closestOnSegment(const Double3& p, const Double3& a, const Double3& b) {
    const Double3 ab = b - a;
    const double along = dot(p - a, ab), whole = lengthSquared(ab);
    if (along <= 0 || whole == 0) return a;
    return along >= whole ? b : a + ab * (along / whole);
}

/// Nearest point to `p` on triangle a b c, by the side of each edge that the foot point lies on. A triangle
/// without area is its edges.
inline Double3 closestOnTriangle(const Double3& p, const Double3& a, const Double3& b, const Double3& c) {
    const Double3 normal = cross(b - a, c - a);
    const double whole = lengthSquared(normal);
    if (whole > 0) {
        const double u = dot(normal, cross(c - b, p - b)), v = dot(normal, cross(a - c, p - c));
        const double w = dot(normal, cross(b - a, p - a));
        if (u >= 0 && v >= 0 && w >= 0) return p - normal * (dot(normal, p - a) / whole);
    }
    Double3 best = closestOnSegment(p, a, b);
    for (const Double3& other : {closestOnSegment(p, b, c), closestOnSegment(p, c, a)})
        if (lengthSquared(p - other) < lengthSquared(p - best)) best = other;
    return best;
}

/// Certainly no nearer to `p` than the root of `bound_squared` (m^2): a third of the work of
/// closestOnTriangle(). False of triangles so slender that rounding would decide.
inline bool isFartherFromTriangle(const Double3& p, const Double3& a, const Double3& b, const Double3& c,
                                  double bound_squared) {
    constexpr double kSlender = 1e-6, kRounding = 1e-7, kRoom = 1.01;
    const Double3 ab = b - a, ac = c - a, ap = p - a, normal = cross(ab, ac);
    const double ab2 = lengthSquared(ab), ac2 = lengthSquared(ac), whole = lengthSquared(normal);
    if (!(whole > kSlender * kSlender * ab2 * ac2)) return false;
    const double limit =
        whole * (kRoom * bound_squared + kRounding * kRounding * (ab2 + ac2 + lengthSquared(ap)));
    const double height = dot(normal, ap), rest = limit - height * height;
    if (rest < 0) return true;
    const auto isBeyond = [&](const Double3& edge, const Double3& from) {
        const double across = dot(normal, cross(edge, from));
        return across < 0 && across * across > rest * lengthSquared(edge);
    };
    return isBeyond(ab, ap) || isBeyond(c - b, p - b) || isBeyond(a - c, p - c);
}

}  // namespace demolish
