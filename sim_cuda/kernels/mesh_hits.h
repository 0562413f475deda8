// SPDX-License-Identifier: Apache-2.0
// When what falls will hit a mesh. No tangent plane bounds a mesh, so the way is walked along.
#pragma once
#include "sim_cuda/data/colliders.h"

namespace demolish {

/// Of a particle, or of what else is a ball to a collider.
template <class Real>
struct FallingBall {
    Vec3<Real> position, velocity, gravity;  ///< m, m/s, m/s^2
    Real radius{};                           ///< m
};

inline constexpr double kNeverHit = 1e30;  ///< s
/// Looks that are taken at most.
inline constexpr uint32_t kHitLooks = 16;

/// s until the ball meets the mesh faster than `limit` (m/s) along its normal; kNeverHit: not within `until`.
template <class Real>
DEM_APART Real meshHitTime(const ColliderRows<Real> mesh, const FallingBall<Real> ball, Real limit,
                           Real until) {
    const Real fastest = length(ball.velocity) + until * length(ball.gravity);
    const Real least = until / Real(kHitLooks);
    Real time{};
    for (uint32_t look = 0; look <= kHitLooks && !(time > until); ++look) {
        const Vec3<Real> velocity = axpy(time, ball.gravity, ball.velocity);
        const Vec3<Real> middle = axpy(Real(0.5) * time, ball.gravity, ball.velocity);
        const TangentPlane<Real> tangent =
            tangentOfMesh(mesh, axpy(time, middle, ball.position), Vec3<Real>{});
        const Real gap = tangent.distance - ball.radius;
        if (!(gap > Real(0)) && -dot(xyz(tangent.plane), velocity) > limit) return time;
        time += maxOf(sureDistance(gap) / fastest, least);
    }
    return Real(kNeverHit);
}

/// The same of mesh c, walked only where its box may be met.
template <class Real>
DEM_FN Real timeToMesh(const ColliderSet<Real>& colliders, uint32_t c, const FallingBall<Real>& ball,
                       Real limit, Real until) {
    const Real fastest = length(ball.velocity) + until * length(ball.gravity);
    const bool may_meet =
        fastest > limit && colliders.bound(c, ball.position).distance < madd(until, fastest, ball.radius);
    return may_meet ? meshHitTime(colliders.collider[c], ball, limit, until) : Real(kNeverHit);
}

}  // namespace demolish
