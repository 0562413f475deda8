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

}  // namespace demolish
