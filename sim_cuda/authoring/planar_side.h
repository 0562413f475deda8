// SPDX-License-Identifier: Apache-2.0
// The sign on which ray crossings rest: on which side of an edge the origin lies, in a projection to the
// plane.
#pragma once
#include <cmath>

namespace demolish {

/// Twice the signed area of (origin, a, b); swapping a and b negates it exactly, so two triangles never
/// disagree about their common edge. 0 when rounding could hide the sign.
inline double edgeSide(double ax, double ay, double bx, double by) {
    constexpr double kRounding = 4.5e-16;  // two products and a difference, half an ulp each, with room
    const double left = ax * by, right = ay * bx, side = left - right;
    return std::abs(side) <= kRounding * (std::abs(left) + std::abs(right)) ? 0 : side;
}

}  // namespace demolish
