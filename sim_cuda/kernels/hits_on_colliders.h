// SPDX-License-Identifier: Apache-2.0
// When a particle is about to hit a collider so hard that it has to be moved in substeps.
#pragma once
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/kernels/meetings.h"
#include "sim_cuda/kernels/mesh_hits.h"

namespace demolish {

/// When a particle is hit hard: both may be true, and each is found by whoever goes through that part of the
/// rows, so that any number of threads finds the same.
struct HardHits {
    bool later = false, at_once = false;
};

/// m/s, faster than anything.
inline constexpr double kNeverHard = 1e15;
/// Of its radius: what comes farther in a contact step and meets a collider that is no plane is met in
/// substeps too. On edges the way off turns by much within so long a step, and energy came from nowhere (6 %
/// of what a crumb had brought).
inline constexpr double kFarToShape = 0.2;

/// What a particle may fall on, and how.
template <class Real>
struct HitsOnColliders {
    ColliderSet<Real> colliders;
    Vec3<Real> gravity;   ///< m/s^2
    Real contact_step{};  ///< s

    /// Hits before the next decision, faster than `breaking` (m/s; kNeverHard: none) along the normal.
    DEM_FN HardHits find(const MeetingsIn<Real>& meetings, uint32_t i, Real breaking) const {
        const FallingBall<Real> ball{positionOf(meetings.state, i), xyz(meetings.state.velocity[i]), gravity,
                                     meetings.constants[i].floor_radius};
        const Real far = Real(kFarToShape) * ball.radius / contact_step;
        const bool goes_far = length2(ball.velocity) > far * far;
        HardHits hard;
        for (uint32_t c = 0; c < colliders.count; ++c) {
            const Real limit = goes_far && !colliders.isPlane(c) ? Real(0) : breaking;
            if (!(limit < Real(kNeverHard))) continue;
            const HardHits on =
                colliders.isMesh(c) ? onMesh(meetings, c, ball, limit) : onTangent(meetings, c, ball, limit);
            hard = {hard.later || on.later, hard.at_once || on.at_once};
        }
        return hard;
    }

  private:
    DEM_FN HardHits onMesh(const MeetingsIn<Real>& meetings, uint32_t c, const FallingBall<Real>& ball,
                           Real limit) const {
        const Real time = timeToMesh(colliders, c, ball, limit, meetings.soon);
        const bool hits = !(time > meetings.soon), at_once = !(time > meetings.at_once);
        return {hits && !at_once, hits && at_once};
    }
    DEM_FN HardHits onTangent(const MeetingsIn<Real>& meetings, uint32_t c, const FallingBall<Real>& ball,
                              Real limit) const {
        const TangentPlane<Real> tangent = colliders.bound(c, ball.position);
        const Vec3<Real> normal = xyz(tangent.plane);
        const Real gap = tangent.distance - ball.radius;
        const Real falling = -dot(normal, gravity), closing = -dot(normal, ball.velocity);
        const auto reaches = [&](Real t) { return madd(t, closing, Real(0.5) * t * t * falling) > gap; };
        const bool hits = isFaster(limit, closing, falling, gap) && reaches(meetings.soon);
        const bool at_once = hits && reaches(meetings.at_once);
        return {hits && !at_once, at_once};
    }
    /// When it arrives: frames may be long, and what falls gets faster.
    DEM_FN static bool isFaster(Real limit, Real closing, Real falling, Real gap) {
        if (!(gap > Real(0)) || !(falling > Real(0))) return closing > limit;
        return madd(closing, closing, Real(2) * falling * gap) > limit * limit;
    }
};

}  // namespace demolish
