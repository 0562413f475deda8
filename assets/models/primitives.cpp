// SPDX-License-Identifier: Apache-2.0
// Closed forms of the recipe's shapes.
#include "assets/models/primitives.h"

#include <algorithm>

namespace demolish::sculptor {

Frame Frame::of(const Turn& turn) {
    constexpr double kRadians = 3.14159265358979323846 / 180;
    // Rounded, so that the last bit of another mathematics library cannot change a mesh.
    const auto cosine = [](double degrees) { return std::round(std::cos(degrees * kRadians) * 1e12) / 1e12; };
    const auto sine = [](double degrees) { return std::round(std::sin(degrees * kRadians) * 1e12) / 1e12; };
    const double cp = cosine(turn.pitch), sp = sine(turn.pitch);
    const double cy = cosine(turn.yaw), sy = sine(turn.yaw);
    const double cr = cosine(turn.roll), sr = sine(turn.roll);
    const auto yawPitch = [&](Vec3 v) {
        const Vec3 pitched{v.x, v.y * cp + v.z * sp, v.z * cp - v.y * sp};
        return Vec3{pitched.x * cy + pitched.z * sy, pitched.y, pitched.z * cy - pitched.x * sy};
    };
    return {yawPitch({cr, sr, 0}), yawPitch({-sr, cr, 0}), yawPitch({0, 0, 1})};
}

double ellipsoidDistance(Vec3 p, Vec3 r) {
    const Vec3 q{p.x / r.x, p.y / r.y, p.z / r.z};
    const double k0 = length(q);
    const double k1 = length({q.x / r.x, q.y / r.y, q.z / r.z});
    // At the very centre the quotient is 0/0; its limit depends on the direction, and the shortest is the
    // distance.
    if (k1 == 0) return -std::min({r.x, r.y, r.z});
    return k0 * (k0 - 1) / k1;
}

double roundConeDistance(Vec3 p, Vec3 a, double ra, Vec3 b, double rb) {
    const Vec3 axis = b - a, from_a = p - a;
    const double l = length(axis);
    if (l <= std::abs(ra - rb)) return ra > rb ? length(from_a) - ra : length(p - b) - rb;
    // In the half plane (t along the axis, rho away from it) the mantle is the line with normal (s, c) that
    // touches both circles; `along` runs on it from 0 where it leaves the first circle to l c where it meets
    // the second.
    const double t = dot(from_a, axis) / l;
    const double rho = std::sqrt(std::max(0.0, dot(from_a, from_a) - t * t));
    const double s = (ra - rb) / l, c = std::sqrt(1 - s * s);
    const double along = t * c - rho * s;
    if (along < 0) return length(from_a) - ra;
    if (along > l * c) return length(p - b) - rb;
    return t * s + rho * c - ra;
}

double smoothUnion(double a, double b, double k) {
    const double overlap = k - std::abs(a - b);
    const double least = std::min(a, b);
    return overlap > 0 ? least - overlap * overlap / (4 * k) : least;
}

double smoothSubtraction(double a, double b, double k) {
    return -smoothUnion(-a, b, k);
}

}  // namespace demolish::sculptor
