// SPDX-License-Identifier: Apache-2.0
// Quadric arithmetic; the minimum by Cramer's rule.
#include "assets/models/quadric.h"

namespace demolish::sculptor {

Quadric Quadric::plane(Vec3 n, Vec3 point, double w) {
    const double d = dot(n, point);
    return {w * n.x * n.x, w * n.x * n.y, w * n.x * n.z, w * n.y * n.y,
            w * n.y * n.z, w * n.z * n.z, (w * d) * n,   w * d * d};
}

double Quadric::at(Vec3 p) const {
    const Vec3 ap{xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z,
                  xz * p.x + yz * p.y + zz * p.z};
    return dot(p, ap) - 2 * dot(b, p) + c;
}

Vec3 Quadric::minimum(Vec3 guess) const {
    const double trace = xx + yy + zz;
    if (!(trace > 0)) return guess;
    // Solved for the step from the guess, so that rounding does not grow with the distance from the origin.
    const double pull = 1e-3 * trace;
    const Vec3 c0{xx + pull, xy, xz}, c1{xy, yy + pull, yz}, c2{xz, yz, zz + pull};
    const Vec3 rest{b.x - (xx * guess.x + xy * guess.y + xz * guess.z),
                    b.y - (xy * guess.x + yy * guess.y + yz * guess.z),
                    b.z - (xz * guess.x + yz * guess.y + zz * guess.z)};
    const double det = dot(c0, cross(c1, c2));
    return guess +
           (1 / det) * Vec3{dot(rest, cross(c1, c2)), dot(c0, cross(rest, c2)), dot(c0, cross(c1, rest))};
}

Quadric operator+(const Quadric& a, const Quadric& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy,
            a.yz + b.yz, a.zz + b.zz, a.b + b.b,   a.c + b.c};
}

}  // namespace demolish::sculptor
