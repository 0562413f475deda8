// SPDX-License-Identifier: Apache-2.0
// Two bodies pressed on each other without a bond: plain contact, the faces of a broken bond, a particle on a
// plane. One law for all three (physics A.2, A.5; models E.4, E.5): spring and damper along the line of
// centres, never pulling except by adhesion, a tangential spring cut at mu N, rolling resistance; and what of
// it the ledger books. Odd in i and j to the last bit.
#pragma once
#include "sim_cuda/physics/rolling_resistance.h"
#include "sim_cuda/physics/tangential_spring.h"
#include "sim_cuda/physics/touch_law.h"

namespace demolish {

/// m/s: below this speed of approach the dampers of contact steps pass over to those of the fragment's share.
/// A fall from 2 mm; hardly a drum that rocks hits the floor harder.
inline constexpr double kRestApproach = 0.2;

template <class T>
struct TouchGeometry {
    Vec3<T> normal;  ///< unit, from i to j
    T overlap{};     ///< m, > 0
    T arm_i{};       ///< m, from i's centre to the common point, along the normal
    T arm_j{};       ///< m, from j's centre to it, against the normal
};

template <class T>
struct TouchEffect {
    Wrench<T> load;      ///< on i
    Vec3<T> spring;      ///< m, tangential spring after the step
    Wrench<T> damping;   ///< on i, the normal damper's share
    Wrench<T> friction;  ///< on i, of tangential force and rolling resistance
    T spring_energy{};   ///< J, stored in the tangential spring after the step
    T opening{};         ///< m/s, along the normal
};

/// 1 where nothing approaches or parts, 0 from kRestApproach on. `opening`: m/s.
template <class T>
DEM_FN T restShare(T opening) {
    return maxOf(T(1) - opening * opening * T(1 / (kRestApproach * kRestApproach)), T(0));
}

/// N s/m.
template <class T>
struct Dampers {
    T normal{}, shear{};
};
template <StepKind kStep, class T>
DEM_FN Dampers<T> dampers(const TouchLaw<T>& law, T opening) {
    if constexpr (kStep == StepKind::kSubstep) return {law.normal_damping, law.shear_damping};
    const T share = restShare(opening);
    return {madd(share, law.resting, law.normal_damping), madd(share, law.shear_resting, law.shear_damping)};
}

/// Spring as it was; i and j as in PairMotion (of which positions and rotations are not used).
template <StepKind kStep = StepKind::kSubstep, class T>
DEM_FN TouchEffect<T> touchEffect(const TouchGeometry<T>& at, const TouchLaw<T>& law,
                                  const PairMotion<T>& pair, const Vec3<T>& spring, T dt) {
    const Vec3<T> arm_i = at.arm_i * at.normal, arm_j = -at.arm_j * at.normal;
    const Vec3<T> relative =
        (pair.velocity_j + cross(pair.spin_j, arm_j)) - (pair.velocity_i + cross(pair.spin_i, arm_i));
    const T opening = dot(relative, at.normal);
    const Vec3<T> slip = axpy(-opening, at.normal, relative);
    const Dampers<T> damping = dampers<kStep>(law, opening);
    const T normal = repulsion(law.elastic, damping.normal, -opening);
    const TangentialResult<T> tangential = tangentialSpring(
        spring, at.normal, slip, dt, law.shear, damping.shear, frictionLimit(law.friction, law.elastic));
    const Vec3<T> rolling =
        rollingTorque(law.rolling, law.radius, law.elastic, law.inertia, pair.spin_j - pair.spin_i, dt);
    TouchEffect<T> effect;
    effect.load.force = axpy(law.adhesion - normal, at.normal, tangential.force);
    effect.load.torque = cross(arm_i, effect.load.force) + rolling;
    effect.spring = tangential.spring;
    effect.damping.force = (law.elastic - normal) * at.normal;  // on the line of centres: no torque
    effect.friction = {tangential.force, cross(arm_i, tangential.force) + rolling};
    effect.opening = opening;
    effect.spring_energy = T(0.5) * law.shear * length2(tangential.spring);
    return effect;
}

/// m, overlap one step before; `opening` m/s.
template <class T>
DEM_FN T overlapBefore(T overlap, T opening, T dt) {
    return madd(dt, opening, overlap);
}

/// What an overlap now and one step before leave to the ledger, m^2; of several points the sum.
template <class T>
struct OverlapChange {
    T crossed{};  ///< of one that has begun or ended in between
    T held{};     ///< of one that goes on
};
template <class T>
DEM_FN OverlapChange<T> overlapChange(T overlap, T before) {
    const T product = overlap * before;
    if ((overlap > T(0)) == (before > T(0))) return {T(0), maxOf(overlap, T(0)) * before};
    return {(overlap > T(0) ? T(-0.5) : T(0.5)) * product, T(0)};
}
template <class T>
DEM_FN void add(OverlapChange<T>& sum, T share, const OverlapChange<T>& term) {
    sum = {madd(share, term.crossed, sum.crossed), madd(share, term.held, sum.held)};
}

/// J that a linear contact takes beyond what its spring holds in the step in which it begins, and less than
/// nothing in the one after its end: a force acts from half a step before its moment to half a step after it,
/// while only a part of that way presses the two together. 2 % of what the stiffest contacts dissipate.
template <class T>
DEM_FN T crossingLoss(T stiffness, const OverlapChange<T>& change) {
    return stiffness * change.crossed;
}

/// J that a contact loses when it becomes softer than it was (`kept`, N/m), and less than nothing where it
/// becomes stiffer: its overlap was brought about half at the old stiffness and half at the new one.
/// `spring`: m, the tangential one.
template <class T>
DEM_FN T softeningLoss(const TouchLaw<T>& law, T kept, const OverlapChange<T>& change,
                       const Vec3<T>& spring) {
    if (!(law.softens && kept > T(0) && law.stiffness > T(0))) return T(0);
    return T(0.5) * (kept - law.stiffness) * madd(law.shear / law.stiffness, length2(spring), change.held);
}

/// J: of the linear spring (1/2 F delta) or Hertz's (2/5 F delta), and of the tangential spring (m).
template <class T>
DEM_FN T touchEnergy(const TouchLaw<T>& law, const TouchStep<T>& step, T overlap, const Vec3<T>& spring) {
    const T share = step.hertz != 0 ? T(0.4) : T(0.5);
    return share * law.elastic * overlap + T(0.5) * law.shear * length2(spring);
}

}  // namespace demolish
