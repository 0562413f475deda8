// SPDX-License-Identifier: Apache-2.0
// When, on straight paths, something touches a body fast enough to break it, and from where it comes.
#pragma once
#include <bit>

#include "sim_cuda/kernels/islands.h"

namespace demolish {

template <class Real>
struct Touch {
    Real time = Real(1e30);  ///< s from now
    Vec3<Real> approach;     ///< m/s, of what comes against the body
};
/// Times are compared as words, which keep their order.
template <class Real>
DEM_FN uint32_t wordOfTime(Real time) {
    return std::bit_cast<uint32_t>(static_cast<float>(time));
}

/// Spheres that part by `separation` (m, to the other) at `approach` (m/s, of the other), closing faster than
/// `limit` (m/s) when they are `reach` (m) apart: s until then, 1e30 if never. Overlapping ones: 0.
template <class Real>
DEM_FN Real touchTime(const Vec3<Real>& separation, const Vec3<Real>& approach, Real reach, Real limit) {
    constexpr Real kNever = Real(1e30);
    const Real closing = -dot(separation, approach), apart2 = length2(separation), reach2 = reach * reach;
    if (!(closing > Real(0))) return kNever;
    if (apart2 <= reach2) return closing * closing > limit * limit * apart2 ? Real(0) : kNever;
    const Real speed2 = length2(approach), rest = closing * closing - speed2 * (apart2 - reach2);
    return rest > limit * limit * reach2 ? (closing - squareRoot(rest)) / speed2 : kNever;
}
/// The same against a plane at the distance `gap` (m), with the acceleration `falling` (m/s^2) towards it.
template <class Real>
DEM_FN Real touchTime(Real gap, Real closing, Real falling, Real limit) {
    constexpr Real kNever = Real(1e30);
    const Real way = maxOf(gap, Real(0)), speed2 = closing * closing + Real(2) * falling * way;
    if (!(closing > Real(0)) || !(speed2 > limit * limit)) return kNever;
    return Real(2) * way / (closing + squareRoot(speed2));
}

/// What decides for all particles of bodies; rules.wake: by releaseLaw().
template <class Real>
struct HardTouches {
    HitRules<Real> rules;
    ColliderSet<Real> colliders;
    Vec3<Real> gravity;  ///< m/s^2

    /// The first that particle i of a body meets before the next decision.
    DEM_FN Touch<Real> of(uint32_t i) const {
        const MeetingsIn<Real>& meetings = rules.meetings;
        Touch<Real> first = onColliders(i);
        meetings.template visitMeetings<1>(i, 0, false, [&](uint32_t j, Real) {
            const Vec3<Real> approach = xyz(meetings.state.velocity[j]) - xyz(meetings.state.velocity[i]);
            const Real time =
                touchTime(positionOf(meetings.state, j) - positionOf(meetings.state, i), approach,
                          meetings.constants[i].contact_radius + meetings.constants[j].contact_radius,
                          rules.limit(i, j));
            if (time < first.time) first = {time, approach};
        });
        return first;
    }

  private:
    DEM_FN Touch<Real> onColliders(uint32_t i) const {
        const MeetingsIn<Real>& meetings = rules.meetings;
        const WakeLaw<Real> own = rules.wake[meetings.owner[i]];
        const Real limit = wakeSpeed(own, own, rules.sizeOf(meetings.label[i]), Real(1e6));
        const Vec3<Real> velocity = xyz(meetings.state.velocity[i]);
        Touch<Real> first;
        const Vec3<Real> position = positionOf(meetings.state, i);
        const Real radius = meetings.constants[i].floor_radius;
        for (uint32_t c = 0; c < colliders.count; ++c) {
            const TangentPlane<Real> bound = colliders.bound(c, position);
            const Vec3<Real> normal = xyz(bound.plane);
            const Real time =
                colliders.isMesh(c)
                    ? timeToMesh(colliders, c, {position, velocity, gravity, radius}, limit, meetings.soon)
                    : touchTime(bound.distance - radius, -dot(normal, velocity), -dot(normal, gravity),
                                limit);
            if (time < first.time) first = {time, -velocity};
        }
        return first;
    }
};

}  // namespace demolish
