// SPDX-License-Identifier: Apache-2.0
// Back past one ball after the other until none is left in the way.
#include "sim_cuda/solver/way_back.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/data/colliders.h"

namespace demolish {
namespace {

/// Of a radius, between the projectile and what it was set back from: the position is rounded to floats.
constexpr double kClearance = 1e-4;

/// m along the unit vector `back` from `at`, for which a ball of `radius` is inside another one: none where
/// last <= 0.
struct Inside {
    double first = 0, last = 0;
};
Inside insideOf(const Ball& other, const Vec3<double>& at, double radius, const Vec3<double>& back) {
    const Vec3<double> offset = other.centre - at;
    const double reach = (1 + kClearance) * (other.radius + radius), along = dot(offset, back);
    const double half2 = reach * reach - (length2(offset) - along * along);
    if (!(half2 > 0)) return {};
    const double half = std::sqrt(half2);
    return {along - half, along + half};
}

/// m to go back until nothing overlaps.
double wayBack(const std::vector<Ball>& others, const Vec3<double>& at, double radius,
               const Vec3<double>& back) {
    std::vector<Inside> ways;
    for (const Ball& other : others) {
        const Inside way = insideOf(other, at, radius, back);
        if (way.last > 0) ways.push_back(way);
    }
    std::sort(ways.begin(), ways.end(), [](const Inside& a, const Inside& b) { return a.first < b.first; });
    double gone = 0;
    for (const Inside& way : ways) {
        if (way.first > gone) break;
        gone = std::max(gone, way.last);
    }
    return gone;
}

Vec3<double> outOf(const ColliderSet<double>& colliders, Vec3<double> at, double radius) {
    forEachCollider(colliders, at, [&](uint32_t c, const TangentPlane<double>&) {
        const TangentPlane<double> now = colliders.tangent(c, at);
        const double sunk = (1 + kClearance) * radius - now.distance;
        if (now.distance < radius) at = axpy(sunk, xyz(now.plane), at);
    });
    return at;
}

}  // namespace

Projectile placedFree(const Projectile& shot, const std::vector<Ball>& others,
                      const std::vector<Collider>& colliders) {
    // Out of a collider may lead into a body once more; along a floor that takes many small steps.
    constexpr int kRounds = 80, kRoundsBack = 64;
    const Vec3<double> velocity{shot.velocity.x, shot.velocity.y, shot.velocity.z}, up{0, 1, 0};
    const double speed = length(velocity);
    const Vec3<double> back = speed > 0 ? (-1 / speed) * velocity : up;
    const auto set = makeColliderSet<double>(colliders);
    Vec3<double> at{shot.position.x, shot.position.y, shot.position.z};
    for (int round = 0; round < kRounds; ++round) {
        at = outOf(set, at, shot.radius);
        const Vec3<double>& way = round < kRoundsBack ? back : up;
        const double far = wayBack(others, at, shot.radius, way);
        if (!(far > 0)) break;
        at = axpy(far, way, at);
    }
    Projectile placed = shot;
    placed.position = {at.x, at.y, at.z};
    return placed;
}

}  // namespace demolish
