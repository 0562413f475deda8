// SPDX-License-Identifier: Apache-2.0
// What particle i gets from one slot that is not a solid bond: a contact of its list, or the record of a
// former bond. Each thread writes its own slot only; both ends of a pair compute the same.
#pragma once
#include "sim_cuda/data/kept_spring.h"
#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/kernels/touch_pair.h"

namespace demolish {

/// Beyond this multiple of R_c,i + R_c,j nothing but the rough position is looked at.
inline constexpr double kRoughReach = 1.01;

/// Line of centres of a pair.
template <class Real>
struct CentreLine {
    Vec3<Real> normal;  ///< unit, from i to j
    Real distance{};    ///< m
};
template <class Real>
DEM_FN CentreLine<Real> centreLine(const Vec3<Real>& separation) {
    const Real squared = length2(separation), inverse = inverseSqrt(squared);
    return {inverse * separation, squared * inverse};
}

template <class Real>
DEM_FN bool outOfReach(const Vec4<Real>& a, const Vec4<Real>& b, Real reach) {
    const Real limit = Real(kRoughReach) * reach;
    return length2(xyz(b) - xyz(a)) > limit * limit;
}

/// m, radii of the spheres of a pair.
template <class Real>
struct Spheres {
    Real own{}, other{};
};
template <class Real>
DEM_FN Spheres<Real> contactSpheres(const ParticleConstants<Real>& own,
                                    const ParticleConstants<Real>& other) {
    return {own.contact_radius, other.contact_radius};
}
/// Of a record that is no bond: kFacing ones reach each other at the distance at which the pair began.
template <class Real>
DEM_FN Spheres<Real> recordedSpheres(const BondLink& link, const Vec4<Real>& rest,
                                     const ParticleConstants<Real>& own,
                                     const ParticleConstants<Real>& other) {
    const Spheres<Real> spheres = contactSpheres(own, other);
    if (pairState(link) != PairState::kFacing) return spheres;
    const Real share = length(xyz(rest)) / (spheres.own + spheres.other);
    return {share * spheres.own, share * spheres.other};
}

/// What the ledger books of a touch; `share` of the pair's energy is this particle's (1 against a collider).
template <class Real>
DEM_FN void bookTouch(const TouchLaw<Real>& law, const TouchEffect<Real>& effect,
                      const OverlapChange<Real>& change, const KeptTouch<Real>& before, Real share,
                      Tally<Real>& tally) {
    tally.contact_loss += share * (crossingLoss(law.stiffness, change) +
                                   softeningLoss(law, before.softest, change, before.spring));
    add(tally.damping, effect.damping);
    add(tally.friction, effect.friction);
    tally.spring_energy += share * (effect.spring_energy - Real(0.5) * law.shear * length2(before.spring));
}
template <class Real>
DEM_FN KeptTouch<Real> touchAfter(const TouchLaw<Real>& law, const TouchEffect<Real>& effect,
                                  const KeptTouch<Real>& before) {
    return {effect.spring, law.softens ? law.stiffness : before.softest, before.unloaded};
}

/// `before`: as it was; writes what it becomes to `slot`, and books half of the pair's energy. `led`: m/s,
/// of ledOpening().
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> applyTouch(const TouchGeometry<Real>& at, const TouchLaw<Real>& law,
                               const PairMotion<Real>& pair, const KeptTouch<Real>& before, Vec4<Real>& slot,
                               const StepParams<Real>& params, Real led, Tally<Real>& tally) {
    const TouchEffect<Real> effect = touchEffect<kStep>(at, law, pair, before.spring, params.dt);
    if constexpr (kLedger) {
        const Real overlap = overlapBefore(at.overlap, effect.opening + led, params.drift);
        bookTouch(law, effect, overlapChange(at.overlap, overlap), before, Real(0.5), tally);
    }
    slot = packed(touchAfter(law, effect, before), at.normal);
    return effect.load;
}

/// Nothing touches any more: what the tangential spring still held is friction heat. Where nothing is held,
/// no step has seen the two touch: a ball that starts beside a body comes, by its velocity, from inside it.
template <bool kLedger, class Real>
DEM_FN void releaseTouch(const TouchLaw<Real>& law, const OverlapChange<Real>& change,
                         const KeptTouch<Real>& before, Vec4<Real>& slot, Real share, Tally<Real>& tally) {
    if (holdsNothing(slot)) return;
    if constexpr (kLedger) tally.contact_loss += share * crossingLoss(law.stiffness, change);
    slot = Vec4<Real>{};
    if constexpr (kLedger) tally.spring_energy -= share * (Real(0.5) * law.shear * length2(before.spring));
}
/// The same where nothing is booked: no law need be known.
template <class Real>
DEM_FN void releaseUnbooked(Vec4<Real>& slot) {
    if (!holdsNothing(slot)) slot = Vec4<Real>{};
}

/// m, from i to j one step before, on a straight way.
template <class Real>
DEM_FN Vec3<Real> formerSeparation(const PairMotion<Real>& pair, Real dt) {
    return axpy(-dt, pair.velocity_j - pair.velocity_i, pair.separation);
}
/// m, overlap of two spheres then; `overlap` and `distance` are those of now.
template <class Real>
DEM_FN Real formerOverlap(const PairMotion<Real>& pair, Real overlap, Real distance, Real dt) {
    return overlap + (distance - length(formerSeparation(pair, dt)));
}
/// Unit: that of the moment for which a touch has been kept. By the normal of now, what bears no load would
/// take in what the tangential spring has along it, and grow as the pair turns: load is lost that nobody
/// books.
template <class Real>
DEM_FN Vec3<Real> keptNormal(const Vec4<Real>& kept, const PairMotion<Real>& pair, const Vec3<Real>& now,
                             Real dt) {
    if (!(kept.w < Real(0))) return now;
    const Vec3<Real> before = formerSeparation(pair, dt);
    return inverseSqrt(length2(before)) * before;
}

/// m, that bears no load: what was found of a touch that has begun unseen, and no more than there is.
template <class Real>
DEM_FN Real unloadedOverlap(const Vec4<Real>& slot, const KeptTouch<Real>& before, Real former,
                            Real overlap) {
    const Real found = holdsNothing(slot) ? maxOf(former, Real(0)) : before.unloaded;
    return minOf(found, maxOf(overlap, Real(0)));
}

/// N/m that the law may not exceed. Contact steps find a share of a whole fragment behind a touch, which
/// could bear more than the particles themselves do in substeps. They make none stiffer than substeps would:
/// at a hand-over the overlap stays, and would hold more than it has taken in.
template <StepKind kStep, class Real>
DEM_FN Real softestOfPair(const StepParams<Real>& params, const PairInertia<Real>& against, Real kept) {
    if (kStep == StepKind::kSubstep) return kept;
    const Real root = inverseSqrt(against.inverse_inertia);
    return noStifferThan(kept, params.own_cap * (root * root));
}

/// m/s, how much faster the two parted along `normal` before a path changed the velocity of either, if that
/// was since the last contact step: their overlap has come about by that. For the ledger.
template <bool kLedger, StepKind kStep, class Real>
DEM_FN Real ledOpening(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                       const OwnParticle<Real>& own, uint32_t j, const ParticleConstants<Real>& other,
                       const Vec3<Real>& normal) {
    if (!kLedger || arrays.led_from.empty()) return Real(0);
    const auto led = [&](uint32_t k, bool carried) {
        if (kStep == StepKind::kContact) return xyz(arrays.led_from[2 * size_t{k}]);
        return carried ? carriedLed(arrays, params, k) : Vec3<Real>{};
    };
    return dot(led(j, other.isMovedByOther()) - led(own.id, own.isCarried()), normal);
}

/// Type 1. `held`: what `slot`, of this end, holds; `led`: m/s, of ledOpening().
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> plainContact(const StepParams<Real>& params, const PairLaw<Real>& pair_law,
                                 const OwnParticle<Real>& own, const ParticleConstants<Real>& other,
                                 const Spheres<Real>& spheres, const PairMotion<Real>& pair,
                                 const CentreLine<Real>& line, const Vec4<Real>& held, Vec4<Real>& slot,
                                 Real led, Tally<Real>& tally) {
    const Real overlap = (spheres.own + spheres.other) - line.distance;
    const bool touches = overlap > Real(0);
    if (!kLedger && !touches) {
        releaseUnbooked(slot);
        return {};
    }
    KeptTouch<Real> before = touchOf(held, keptNormal(held, pair, line.normal, params.drift));
    const Real former = formerOverlap(pair, overlap, line.distance, params.drift);
    before.unloaded = unloadedOverlap(held, before, former, overlap);
    const Real pressed = overlap - before.unloaded;
    const PairInertia<Real> against = pairInertia(own.constants, other);
    const TouchLaw<Real> law =
        contactTouchLaw<kStep>(pair_law, params, maxOf(pressed, Real(0)), reduced(spheres.own, spheres.other),
                               against, softestOfPair<kStep>(params, against, before.softest));
    if (!touches) {
        const Real then = madd(params.drift, led, former);
        releaseTouch<kLedger>(law, overlapChange(overlap, then), before, slot, Real(0.5), tally);
        return {};
    }
    const Real arm_i = madd(Real(-0.5), overlap, spheres.own),
               arm_j = madd(Real(-0.5), overlap, spheres.other);
    return applyTouch<kLedger, kStep>(TouchGeometry<Real>{line.normal, pressed, arm_i, arm_j}, law, pair,
                                      before, slot, params, led, tally);
}

/// Both ends are moved in contact steps and this is a substep, or the other end alone is moved by the other
/// kind of step and this one leaves such pairs out: the pair is no matter of this step.
template <class Real>
DEM_FN bool isLeftOut(const ParticleConstants<Real>& own, const ParticleConstants<Real>& other,
                      const StepParams<Real>& params) {
    return other.isMovedByOther() && (own.isMovedByOther() || params.leaves_out != 0);
}

/// The other end of a contact, as far as it takes to see that nothing touches, and what the slot keeps of it.
/// All of it is asked for at once: most slots need no more, and none less. The GPU reads it for the slot to
/// come while it computes one, and then the owner too, by whom the law is found.
inline constexpr uint32_t kUnknownOwner = 0xffffffffu;
template <class Real>
struct ContactEnd {
    uint32_t id = 0, owner = kUnknownOwner;
    Vec4<Real> position;
    ParticleConstants<Real> constants;
    Vec4<Real> kept;
};
/// Of a slot that is known to lead to particle j, and of an owner that may be known.
template <class Real>
DEM_FN ContactEnd<Real> contactEndOf(const SubstepArrays<Real>& arrays, uint32_t slot, uint32_t j,
                                     uint32_t owner = kUnknownOwner) {
    return {j, owner, arrays.in.position[j], arrays.constants[j], arrays.contact_spring[slot]};
}
template <class Real>
DEM_FN ContactEnd<Real> contactEnd(const SubstepArrays<Real>& arrays, uint32_t slot) {
    return contactEndOf(arrays, slot, arrays.neighbour[slot]);
}
template <class Real>
DEM_FN ContactEnd<Real> contactEndWithOwner(const SubstepArrays<Real>& arrays, uint32_t slot) {
    const uint32_t j = arrays.neighbour[slot];
    return contactEndOf(arrays, slot, j, arrays.owner[j]);
}

/// Nothing more need be read of a contact's other end: the pair is no matter of this step, or is apart and
/// has been since before.
template <class Real>
DEM_FN bool isOutOfTouch(const OwnParticle<Real>& own, const Vec4<Real>& position,
                         const ParticleConstants<Real>& other, const Vec4<Real>& kept,
                         const StepParams<Real>& params) {
    if (isLeftOut(own.constants, other, params) || goThroughEachOther(own.constants, other)) return true;
    return outOfReach(own.state.position, position, own.constants.contact_radius + other.contact_radius) &&
           holdsNothing(kept);
}

/// A slot of the contact list and its other end.
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> contactSlot(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                const OwnParticle<Real>& own, uint32_t slot, const ContactEnd<Real>& end,
                                Tally<Real>& tally) {
    const ParticleConstants<Real> other = end.constants;
    if (isOutOfTouch(own, end.position, other, end.kept, params)) return {};
    const PairMotion<Real> pair = pairMotion(own.state, loadWithoutRotation(arrays.in, end.position, end.id));
    const uint32_t owner = end.owner == kUnknownOwner ? arrays.owner[end.id] : end.owner;
    const PairLaw<Real> law = arrays.pair_laws[own.owner * params.owners + owner];
    const CentreLine<Real> line = centreLine(pair.separation);
    return plainContact<kLedger, kStep>(
        params, law, own, other, contactSpheres(own.constants, other), pair, line, end.kept,
        arrays.contact_spring[slot],
        ledOpening<kLedger, kStep>(arrays, params, own, end.id, other, line.normal), tally);
}

/// A slot of the bonds as it is, and its other end, which is always the same.
struct LinkEnd {
    uint32_t id = 0;
    BondLink link;
};
template <class Real>
DEM_FN LinkEnd linkEnd(const SubstepArrays<Real>& arrays, uint32_t slot) {
    const BondLink link = arrays.link[slot];
    return {linkedParticle(link), link};
}

/// All that a record that is no solid bond needs.
template <class Real>
struct FormerBond {
    uint32_t slot = 0;
    BondLink link;
    LoadedState<Real> other;  ///< without orientation
    ParticleConstants<Real> constants;
    Vec4<Real> rest, spring;
};
/// Stiffnesses of its faces, as this step can bear them.
template <class Real>
DEM_FN BondConstants<Real> facesOf(const FormerBond<Real>& former, const BodyLaw<Real>& body,
                                   const StepParams<Real>& params, const PairInertia<Real>& against) {
    return cappedFaces(bondConstants(former.rest, former.link.grade, body), params, against,
                       softestOf(former.spring));
}
/// Its faces are apart: the step from type 3 to type 1. `overlap`, `rest_length`: m.
template <bool kLedger, class Real>
DEM_FN void partFaces(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                      const OwnParticle<Real>& own, const FormerBond<Real>& former,
                      const PairMotion<Real>& pair, const CentreLine<Real>& line, Real overlap,
                      Real rest_length, Real led, Tally<Real>& tally) {
    Vec4<Real>& slot = arrays.bond_spring[former.slot];
    if constexpr (kLedger) {
        const BondConstants<Real> bond = facesOf(former, arrays.body_laws[own.owner], params,
                                                 pairInertia(own.constants, former.constants));
        TouchLaw<Real> faces;
        faces.stiffness = bond.stiffness.normal;
        faces.shear = bond.stiffness.shear;
        const Real before =
            madd(params.drift, led, formerOverlap(pair, overlap, line.distance, params.drift));
        releaseTouch<true>(faces, overlapChange(overlap, before), touchOf(former.spring, line.normal), slot,
                           Real(0.5), tally);
    } else {
        releaseUnbooked(slot);
    }
    const PairState next = nextState(PairState::kBroken, false, line.distance, rest_length);
    arrays.link[former.slot].link = linkWord(linkedParticle(former.link), next);
}
/// Type 3.
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> brokenBond(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                               const OwnParticle<Real>& own, const FormerBond<Real>& former,
                               const PairMotion<Real>& pair, const CentreLine<Real>& line,
                               Tally<Real>& tally) {
    const Real rest_length = length(xyz(former.rest)), overlap = brokenOverlap(rest_length, line.distance);
    const ParticleConstants<Real>& other = former.constants;
    const Real led =
        ledOpening<kLedger, kStep>(arrays, params, own, linkedParticle(former.link), other, line.normal);
    if (!(overlap > Real(0))) {
        partFaces<kLedger>(arrays, params, own, former, pair, line, overlap, rest_length, led, tally);
        return {};
    }
    const BodyLaw<Real> body = arrays.body_laws[own.owner];
    const PairInertia<Real> against = pairInertia(own.constants, other);
    const Real radius = reduced(own.constants.contact_radius, other.contact_radius);
    const TouchLaw<Real> law =
        brokenTouchLaw(facesOf(former, body, params, against), body.faces, params, overlap, radius, against);
    const Real arm = Real(0.5) * line.distance;
    return applyTouch<kLedger, kStep>(TouchGeometry<Real>{line.normal, overlap, arm, arm}, law, pair,
                                      touchOf(former.spring, line.normal), arrays.bond_spring[former.slot],
                                      params, led, tally);
}

/// Faces may touch before the spheres do.
template <class Real>
DEM_FN bool isApart(const OwnParticle<Real>& own, const Vec4<Real>& position,
                    const ParticleConstants<Real>& other, BondLink link, const Vec4<Real>& kept,
                    const StepParams<Real>& params) {
    if (!hasFaces(link)) return isOutOfTouch(own, position, other, kept, params);
    return isLeftOut(own.constants, other, params) ||
           (pairState(link) == PairState::kFacing && goThroughEachOther(own.constants, other));
}
/// A record that is no solid bond and whose ends are not apart.
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> touchingFormerBond(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                       const OwnParticle<Real>& own, const FormerBond<Real>& former,
                                       Tally<Real>& tally) {
    const PairMotion<Real> pair = pairMotion(own.state, former.other);
    const CentreLine<Real> line = centreLine(pair.separation);
    if (pairState(former.link) == PairState::kBroken)
        return brokenBond<kLedger, kStep>(arrays, params, own, former, pair, line, tally);
    const uint32_t j = linkedParticle(former.link);
    const PairLaw<Real> law = arrays.pair_laws[own.owner * params.owners + arrays.owner[j]];
    if (pairState(former.link) == PairState::kFacing)
        arrays.link[former.slot].link =
            linkWord(j, nextState(PairState::kFacing, false, line.distance, length(xyz(former.rest))));
    return plainContact<kLedger, kStep>(
        params, law, own, former.constants,
        recordedSpheres(former.link, former.rest, own.constants, former.constants), pair, line, former.spring,
        arrays.bond_spring[former.slot],
        ledOpening<kLedger, kStep>(arrays, params, own, j, former.constants, line.normal), tally);
}
/// A record that is no solid bond: of ends that are apart no more is read than it takes to see
/// it.
template <bool kLedger, StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN Wrench<Real> formerBondSlot(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                   const OwnParticle<Real>& own, uint32_t slot, const LinkEnd& end,
                                   Tally<Real>& tally) {
    const Vec4<Real> position = arrays.in.position[end.id];
    const ParticleConstants<Real> other = arrays.constants[end.id];
    const Vec4<Real> kept = arrays.bond_spring[slot];
    if (isApart(own, position, other, end.link, kept, params)) return {};
    const FormerBond<Real> former{slot,  end.link,          loadWithoutRotation(arrays.in, position, end.id),
                                  other, arrays.rest[slot], kept};
    return touchingFormerBond<kLedger, kStep>(arrays, params, own, former, tally);
}

}  // namespace demolish
