// SPDX-License-Identifier: Apache-2.0
// What a particle gets from a collider, in both kinds of step: the corners of its cell below the surface are
// springs side by side. What they press with acts at their centre of pressure, and so do friction and damper.
// A particle without corners is a sphere.
#pragma once
#include <type_traits>

#include "sim_cuda/data/planes_only.h"
#include "sim_cuda/kernels/landing.h"
#include "sim_cuda/kernels/press_on_shape.h"
#include "sim_cuda/kernels/touch_slots.h"

namespace demolish {

/// Steps ahead in which a contact is reckoned with that is still to come.
inline constexpr double kStepsAhead = 1.5;

/// Of collider c, from what bounds it.
template <class Real, class Colliders>
DEM_FN TangentPlane<Real> tangentFrom(const Colliders& colliders, uint32_t c, const OwnParticle<Real>& own,
                                      const TangentPlane<Real>& bound) {
    const LoadedState<Real>& state = own.state;
    return colliders.isMesh(c) ? colliders.tangent(c, xyz(state.position),
                                                   lowPart(state.position, state.velocity, state.spin))
                               : bound;
}

/// Too far from a collider to touch it, now and in the step before, however long that was; `gap`: m, between
/// the two.
template <StepKind kStep, class Real>
DEM_FN bool isClearOf(const OwnParticle<Real>& own, Real gap, Real dt) {
    constexpr Real kSteps = kStep == StepKind::kSubstep ? kRigidStride : 2;
    const Real near = Real(kRoughReach - 1) * own.constants.floor_radius, way = kSteps * dt;
    return gap > near && (gap - near) * (gap - near) > way * way * length2(xyz(own.state.velocity));
}

/// Who looks at how a particle lies on a collider: its own thread, or several together.
template <class Lanes = LaneGroup<1>>
struct LooksItself {
    Lanes lanes{};
    DEM_FN bool leads() const { return lanes.leads(); }
    /// `gap`: m, between the particle and what bounds collider c.
    template <StepKind kStep, class Real>
    DEM_FN bool isClear(const OwnParticle<Real>& own, uint32_t, Real gap, Real dt) const {
        return isClearOf<kStep>(own, gap, dt);
    }
    template <class Real, class Colliders>
    DEM_FN TangentPlane<Real> tangent(const Colliders& colliders, uint32_t c, const OwnParticle<Real>& own,
                                      const TangentPlane<Real>& bound) const {
        return tangentFrom(colliders, c, own, bound);
    }
    template <bool kLedger, bool kHertz, class Real>
    DEM_FN PointsPressed<Real> points(const ColliderRows<Real>& rows, uint32_t, const OwnParticle<Real>& own,
                                      const SeenCell<Real>& cell) const {
        return cornersOnShape<kLedger, kHertz>(rows, poseOf(own, cell), lanes).points;
    }
};
/// The same of a sphere, as projectiles are.
struct LooksAtSphere : LooksItself<> {
    template <bool kLedger, bool kHertz, class Real>
    DEM_FN PointsPressed<Real> points(const ColliderRows<Real>&, uint32_t, const OwnParticle<Real>&,
                                      const SeenCell<Real>&) const {
        return {};
    }
};
/// Others have looked, and left what they found.
template <class Real>
struct FoundOnShape {
    PointsPressed<Real> points;
    TangentPlane<Real> tangent;  ///< of a mesh
};
template <class Real>
struct FoundByOthers {
    const FoundOnShape<Real>* found;  ///< by collider
    uint32_t near;                    ///< bit c: collider c is not too far away
    DEM_FN bool leads() const { return true; }
    template <StepKind kStep>
    DEM_FN bool isClear(const OwnParticle<Real>&, uint32_t c, Real, Real) const {
        return (near >> c & 1) == 0;
    }
    template <class Colliders>
    DEM_FN TangentPlane<Real> tangent(const Colliders& colliders, uint32_t c, const OwnParticle<Real>&,
                                      const TangentPlane<Real>& bound) const {
        return colliders.isMesh(c) ? found[c].tangent : bound;
    }
    template <bool kLedger, bool kHertz>
    DEM_FN PointsPressed<Real> points(const ColliderRows<Real>&, uint32_t c, const OwnParticle<Real>&,
                                      const SeenCell<Real>&) const {
        return found[c].points;
    }
};

/// Colliders, here and below: ColliderSet or PlanesOnly.
template <bool kLedger, bool kHertz, class Real, class Colliders, class Source>
DEM_FN Pressed<Real> pressedAtCorners(const Colliders& colliders, const OwnParticle<Real>& own,
                                      const SeenCell<Real>& cell, uint32_t c,
                                      const TangentPlane<Real>& tangent, const Source& source) {
    if constexpr (std::is_same_v<Colliders, PlanesOnly<Real>>) {
        return pressedOnPlane<kLedger, kHertz>(own, cell, tangent);
    } else {
        if (colliders.isPlane(c)) return pressedOnPlane<kLedger, kHertz>(own, cell, tangent);
        return pressedOnShape<kLedger, kHertz>(
            source.template points<kLedger, kHertz>(colliders.collider[c], c, own, cell), own, cell, tangent);
    }
}
template <bool kLedger, class Real, class Colliders, class Source = LooksItself<>>
DEM_FN Pressed<Real> pressedOn(const StepParams<Real>& params, const Colliders& colliders,
                               const OwnParticle<Real>& own, const SeenCell<Real>& cell, uint32_t c,
                               const TangentPlane<Real>& tangent, const Source& source = {}) {
    if (cell.corners.from_seed.empty()) return pressedSphere(own, cell.drift, tangent);
    return params.hertz != 0 ? pressedAtCorners<kLedger, true>(colliders, own, cell, c, tangent, source)
                             : pressedAtCorners<kLedger, false>(colliders, own, cell, c, tangent, source);
}

/// What is set against a push on a collider.
template <class Real>
struct Turning {
    Real each_inverse{};  ///< 1/kg, of what each contact with a collider bears,
    Real inverse_mass{};  ///< against a push along the normal at the centre of pressure,
    Real slip_inverse{};  ///< and across it,
    Real most_inverse{};  ///< and at most at any corner
    Real inertia{};       ///< kg m^2, that rolls at least
    Real radius{};        ///< m, likewise
    Real damping{1};      ///< share of the damper
};
/// A particle that substeps move turns alone. It rolls away from what acts across, so that half of that is as
/// good as all for the bound on the tangential damper.
template <class Real, class Source = LooksItself<>>
struct TurnsAlone {
    static constexpr StepKind kStep = StepKind::kSubstep;
    OwnCorners<Real> corners;
    Source source{};
    DEM_FN SeenCell<Real> cell(const StepParams<Real>& params, const OwnParticle<Real>& own) const {
        return {corners, asQuat(own.state.rotation), params.drift};
    }
    DEM_FN Turning<Real> operator()(const OwnParticle<Real>& own, const Pressed<Real>& at) const {
        const Real mass = own.constants.inverseMass(), turn = own.constants.inverse_inertia;
        return {mass,
                madd(turn, length2(cross(at.arm, at.normal)), mass),
                Real(0.5) * madd(turn, length2(at.arm), mass),
                madd(turn, own.constants.floor_radius * own.constants.floor_radius, mass),
                Real(0),
                Real(0)};
    }
};

/// Calls visit(c, bound) for every collider, as the particle has it.
template <class Real, class Colliders, class Visit>
DEM_FN void forEachCollider(const Colliders& colliders, const OwnParticle<Real>& own, const Visit& visit) {
    const LoadedState<Real>& state = own.state;
    forEachCollider(colliders, xyz(state.position), lowPart(state.position, state.velocity, state.spin),
                    visit);
}

/// One may touch it in this step, as far as bounds say.
template <StepKind kStep, class Real, class Colliders>
DEM_FN bool isNearColliders(const StepParams<Real>& params, const Colliders& colliders,
                            const OwnParticle<Real>& own) {
    if (own.constants.isHeld() || !own.constants.isMovedHere()) return false;
    bool near = false;
    forEachCollider(colliders, own, [&](uint32_t, const TangentPlane<Real>& bound) {
        near = near || !isClearOf<kStep>(own, bound.distance - own.constants.floor_radius, params.dt);
    });
    return near;
}

/// All springs of a contact together never get stiffer than a share over dt^2, in terms of what answers at
/// the corner that gives way most (a flat cell turns easily under its corners), nor its damper greater than
/// another over dt, in terms of what answers where it presses. Steps are stable while the first and twice the
/// second, added over all that holds a particle, stay below 4. In contact steps that may be spent on one
/// contact, and a restitution of 0.1 asks for it; in substeps half of it is left to bonds: a wall of two
/// cells between its floor, its bond and a ball gained six times what the ball had brought.
template <StepKind kStep>
inline constexpr double kStableShare = kStep == StepKind::kSubstep ? 1.2 : 2.4;
template <StepKind kStep>
inline constexpr double kStableDamping = kStep == StepKind::kSubstep ? 0.4 : 0.8;

/// The law of what is pressed on: springs and damper of all its points.
template <StepKind kStep, class Real>
DEM_FN TouchLaw<Real> pressingLaw(const PairLaw<Real>& wall, const StepParams<Real>& params,
                                  const OwnParticle<Real>& own, const Pressed<Real>& at,
                                  const Turning<Real>& turning, const Landing<Real>& landing,
                                  const Vec4<Real>& kept) {
    const Real radius = own.constants.contact_radius;
    const PairInertia<Real> against{turning.each_inverse, own.constants.inverse_inertia};
    const Real full = fullStiffness(wall, params, against, Real(1) / against.inverse_mass);
    const Real stable =
        Real(kStableShare<kStep>) / (at.springs * turning.most_inverse * (params.dt * params.dt));
    const Real softest = noStifferThan(softestFrom<kStep>(wall, params, full, landing, kept), stable);
    TouchLaw<Real> law =
        contactTouchLaw<kStep>(wall, params, maxOf(at.depth, Real(0)), radius, against, softest);
    law.softens = true;
    law.elastic = at.springs * law.elastic;
    law.normal_damping = minOf(
        contactDamping(wall, params, dampedStiffness<kStep>(full, softest, law.stiffness, landing),
                       contactRadius(radius, at.depth), minOf(at.springs, Real(1)) / turning.inverse_mass),
        Real(kStableDamping<kStep>) / (turning.inverse_mass * params.dt));
    law.normal_damping = turning.damping * law.normal_damping;
    law.shear_damping =
        minOf(law.normal_damping, Real(kShearDampingShare) / (turning.slip_inverse * params.dt));
    law.resting = law.shear_resting = Real(0);
    law.rolling = at.rolling * law.rolling;
    const Real shared = Real(1) / own.constants.inverseMass();
    law.inertia = maxOf(ownMass(againstWall(own.constants), params, radius, shared).inertia, turning.inertia);
    law.radius = maxOf(law.radius, turning.radius);
    return law;
}

/// Seen from a centre that is `across` away, m.
template <class Real>
DEM_FN Wrench<Real> seenFrom(const Vec3<Real>& across, const Wrench<Real>& wrench) {
    return {wrench.force, wrench.torque + cross(across, wrench.force)};
}

template <class Real>
struct ColliderLoad {
    Wrench<Real> wrench;
    bool comes = false;  ///< it does not touch, but the next step will bring it so near
};

/// Collider c: nothing moves on its side. `bound`: of it, from the particle's centre; `turned_with`: what
/// turns with the particle.
template <bool kLedger, class Real, class Colliders, class TurnedWith>
DEM_FN ColliderLoad<Real> colliderContact(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                          const Colliders& colliders, const OwnParticle<Real>& own,
                                          uint32_t c, const TangentPlane<Real>& bound, Tally<Real>& tally,
                                          const TurnedWith& turned_with) {
    constexpr StepKind kStep = TurnedWith::kStep;
    const Real radius = own.constants.floor_radius;
    if (turned_with.source.template isClear<kStep>(own, c, bound.distance - radius, params.dt)) return {};
    const TangentPlane<Real> tangent = turned_with.source.tangent(colliders, c, own, bound);
    if (colliders.isMesh(c) && isClearOf<kStep>(own, sureDistance(tangent.distance) - radius, params.dt))
        return {};
    const Pressed<Real> at = pressedOn<kLedger>(params, colliders, own, turned_with.cell(params, own), c,
                                                tangent, turned_with.source);
    if (!turned_with.source.leads()) return {};
    Vec4<Real>& spring = arrays.collider_spring[c * params.total + own.id];
    const KeptTouch<Real> before{xyz(spring), softestOf(spring)};
    const Real down = -dot(at.arm, at.normal);
    const Vec3<Real> across = axpy(down, at.normal, at.arm);
    const Vec3<Real> velocity = xyz(own.state.velocity) + cross(xyz(own.state.spin), across);
    const Real approach = -dot(velocity, at.normal);
    const PairLaw<Real>& wall = wallLaw(arrays, params, own.owner, c);
    const auto law_now = [&](const Landing<Real>& landing, const Vec4<Real>& kept) {
        return pressingLaw<kStep>(wall, params, own, at, turned_with(own, at), landing, kept);
    };
    if (!(at.depth > Real(0))) {
        releaseTouch<kLedger>(kLedger ? law_now({approach}, spring) : TouchLaw<Real>{}, at.change, before,
                              spring, Real(1), tally);
        return {{}, at.gap < Real(kStepsAhead) * params.dt * approach};
    }
    const Landing<Real> landing = landingOf<kStep>(wall, arrays, params, own, at.normal, approach, spring);
    const TouchLaw<Real> law = law_now(landing, hardened<kStep>(params, approach, spring));
    PairMotion<Real> pair;
    pair.velocity_i = velocity;
    pair.spin_i = xyz(own.state.spin);
    TouchEffect<Real> effect =
        touchEffect<kStep>({-at.normal, at.depth, down, Real(0)}, law, pair, before.spring, params.dt);
    effect.damping = seenFrom(across, effect.damping);
    effect.friction = seenFrom(across, effect.friction);
    Wrench<Real> load = seenFrom(across, effect.load);
    if (!colliders.isPlane(c)) load.torque = axpy(law.elastic, at.couple, load.torque);
    if constexpr (kLedger) bookTouch(law, effect, at.change, before, Real(1), tally);
    // A dry substep leaves the fragment's velocity as it is.
    if (landing.isHard() && params.booked == KickShare::kAll)
        pushFragment(arrays, own.id, params.dt * effect.load.force);
    spring = markedHard(packed(touchAfter(law, effect, before), at.normal), landing.isHard());
    return {load, false};
}

}  // namespace demolish
