// SPDX-License-Identifier: Apache-2.0
// Sum of squared distances to planes: the error that edge collapse keeps small (Garland and Heckbert 1997).
#pragma once
#include "assets/models/vec3.h"

namespace demolish::sculptor {

/// p' A p - 2 b' p + c, with A symmetric (upper triangle xx xy xz yy yz zz).
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Vec3 b;
    double c = 0;

    /// `weight` times the squared distance to the plane through `point` with unit normal `normal`.
    static Quadric plane(Vec3 normal, Vec3 point, double weight);

    double at(Vec3 p) const;

    /// The point of least error, taking it from `guess` where the planes leave it free (flat or straight
    /// surroundings): a small pull to `guess` makes the system solvable everywhere.
    Vec3 minimum(Vec3 guess) const;
};

Quadric operator+(const Quadric& a, const Quadric& b);

}  // namespace demolish::sculptor
