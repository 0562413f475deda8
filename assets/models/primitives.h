// SPDX-License-Identifier: Apache-2.0
// Signed distances of the three shapes that recipes are made of, and the smooth operations that join them
// (assets.md 1.4). Lengths in the recipe's unit; negative inside.
#pragma once
#include "assets/models/vec3.h"

namespace demolish::sculptor {

/// Angles in degrees: pitch > 0 lifts the front (+z), yaw > 0 turns the front to +x, roll > 0 leans the top
/// to -x.
struct Turn {
    double pitch = 0, yaw = 0, roll = 0;
};

/// World axes of a turned shape: yaw * pitch * roll.
struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    static Frame of(const Turn& turn);
    /// The direction `v` seen from the turned shape.
    Vec3 toLocal(Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

/// Approximate distance to an ellipsoid at the origin: k0 (k0 - 1) / k1 with k0 = |p/r|, k1 = |p/r^2|. Exact
/// on the surface and for a sphere; `p` in the ellipsoid's own axes.
double ellipsoidDistance(Vec3 p, Vec3 radii);

/// Exact distance to the hull of two spheres.
double roundConeDistance(Vec3 p, Vec3 a, double ra, Vec3 b, double rb);

/// Union whose seam is rounded within |a - b| < k; grows by k/4 at most. k = 0 is the plain union.
double smoothUnion(double a, double b, double k);

/// `a` without `b`, the edge rounded alike.
double smoothSubtraction(double a, double b, double k);

}  // namespace demolish::sculptor
