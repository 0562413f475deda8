// SPDX-License-Identifier: Apache-2.0
// What acts on one particle of a rigid fragment: the faces of broken bonds to other fragments, contacts,
// colliders. The laws are those of a substep; only the step is longer, and a particle carries its share of
// the fragment's mass.
#pragma once
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/collider_contact.h"
#include "sim_cuda/kernels/partial_sums.h"

namespace demolish {

/// A part of what acts on one active particle. Aligned, so that it takes as few reads as can be.
template <class Real>
struct alignas(32) RigidPush {
    Wrench<Real> wrench;    ///< about the particle's centre
    uint32_t touching = 0;  ///< contacts that give it
    uint32_t coming = 0;    ///< contacts with colliders that the next step will bring

    DEM_FN void operator+=(const RigidPush& other) {
        add(wrench, other.wrench);
        touching += other.touching;
        coming += other.coming;
    }
};
template <class Real>
struct RigidLoad {
    RigidPush<Real> push;
    Tally<Real> tally;  ///< filled only for the ledger
};

/// What neighbours give a particle, and what colliders give it: a GPU gathers the two side by side, since
/// either is a long way of reads that wait for one another.
template <class Real>
struct RigidLoadsOf {
    RigidPush<Real> rows, colliders;
    Tally<Real> rows_tally, colliders_tally;

    template <bool kLedger>
    DEM_FN void keepRows(const RigidLoad<Real>& load) {
        rows = load.push;
        if constexpr (kLedger) rows_tally = load.tally;
    }
    template <bool kLedger>
    DEM_FN void keepColliders(const RigidLoad<Real>& load) {
        colliders = load.push;
        if constexpr (kLedger) colliders_tally = load.tally;
    }
    DEM_FN uint32_t standing() const { return colliders.touching; }
    DEM_FN RigidPush<Real> push() const {
        RigidPush<Real> sum = rows;
        sum += colliders;
        return sum;
    }
    DEM_FN Tally<Real> tally() const {
        Tally<Real> sum = rows_tally;
        sum += colliders_tally;
        return sum;
    }
};

template <class Real>
DEM_FN bool isNullWrench(const Wrench<Real>& a) {
    return !(length2(a.force) > Real(0)) && !(length2(a.torque) > Real(0));
}

/// Counted when it gives anything.
template <class Real>
DEM_FN Wrench<Real> counted(const Wrench<Real>& wrench, uint32_t& touching) {
    if (!isNullWrench(wrench)) ++touching;
    return wrench;
}

/// Whether a contact is one with what substeps move, which compute it, and has been touching: such a one
/// keeps the stiffness of the fragment's others. `other`: in contact steps.
template <class Real>
DEM_FN bool keepsTouching(const ParticleConstants<Real>& other, const Vec4<Real>& spring) {
    return other.isMovedByOther() && hasBeenSofter(spring);
}

/// A slot of either list. `other`: the other end.
template <class Real, class Slot>
DEM_FN Wrench<Real> countedSlot(const ParticleConstants<Real>& other, const Vec4<Real>& spring,
                                uint32_t& touching, const Slot& slot) {
    if (keepsTouching(other, spring)) ++touching;
    return counted(slot(), touching);
}
/// The other end of a bond's record or of a contact, and its fragment, neither of which a contact step
/// changes: most of those that are listed are of the same one.
struct OtherFragment {
    uint32_t id = 0, label = 0;
};
/// A bond record: nothing from one whose ends are of the same fragment, as those of solid ones are.
template <bool kLedger, class Real>
DEM_FN Wrench<Real> countedBondSlot(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                    uint32_t own_label, const OwnParticle<Real>& own, uint32_t slot,
                                    const OtherFragment& other, RigidLoad<Real>& load) {
    if (other.label == own_label) return {};
    const LinkEnd end = linkEnd(arrays, slot);
    return countedSlot(arrays.constants[end.id], arrays.bond_spring[slot], load.push.touching, [&] {
        return formerBondSlot<kLedger, StepKind::kContact>(arrays, params, own, slot, end, load.tally);
    });
}
template <class Real>
DEM_FN OtherFragment contactFragment(const SubstepArrays<Real>& arrays, const Span<const uint32_t>& label,
                                     uint32_t slot) {
    const uint32_t j = arrays.neighbour[slot];
    return {j, label[j]};
}
template <class Real>
DEM_FN OtherFragment bondFragment(const SubstepArrays<Real>& arrays, const Span<const uint32_t>& label,
                                  uint32_t slot) {
    const uint32_t j = linkedParticle(arrays.link[slot]);
    return {j, label[j]};
}
/// Nothing within a fragment here either.
template <bool kLedger, class Real>
DEM_FN Wrench<Real> countedContactSlot(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                       uint32_t own_label, const OwnParticle<Real>& own, uint32_t slot,
                                       const OtherFragment& other, RigidLoad<Real>& load) {
    if (other.label == own_label) return {};
    const ContactEnd<Real> end = contactEndOf(arrays, slot, other.id);
    return countedSlot(end.constants, end.kept, load.push.touching, [&] {
        return contactSlot<kLedger, StepKind::kContact>(arrays, params, own, slot, end, load.tally);
    });
}

/// A piece that lies rolls as the ball of its size does, at this share of its radius; by the radius of a
/// cell, which stands there for the piece, drums rolled on for metres. What stands higher than that ball
/// topples rather than rolls: there the share falls by the square of the height, or leaning pieces would
/// stand, and the wolf's break a tenth fewer bonds.
inline constexpr double kRollingRadiusShare = 0.5;

/// What all of a fragment's contacts may take of its spin in a step, over what one of a particle may (a
/// fifth): less and a piece that leans beyond what rolling resistance holds creeps for seconds.
inline constexpr double kRollingGrip = 4;

/// Contacts with colliders among which the mass of a fragment is shared. What touches already when its bonds
/// come to rest goes on as soft as any contact: the harder it pressed in a longer step, the more leapfrog
/// would change its energy (physics B.1).
DEM_FN double standShare(const RigidBody& body) {
    if (body.starts != 0) return body.contact_share;
    return maxOf(body.least_stand, double(body.standing) / kContactsPerShare);
}

/// Contacts with colliders for which a spring leaves room, even where there is one. A corner that comes a
/// whole step deep is pushed off by up to kStableShare of its speed over that, beside what its damper takes:
/// with room for one alone the tip of a slender plate could come off 1.4 times as fast as it had landed.
inline constexpr double kFewestStanding = 2;

/// A rigid fragment's contact with a collider: its share of what the whole sets against a push there, over
/// all contacts, so that it gives back what its restitution says however many touch; and its share of the
/// turning, whichever way the fragment rolls, over those of the step before and one more.
template <class Real, class Source = LooksItself<>>
struct TurnsFragment {
    static constexpr StepKind kStep = StepKind::kContact;
    RigidWork work;
    OwnCorners<Real> corners;
    Source source{};
    /// What is softened in the first contact step of a body has got its overlap in a substep.
    DEM_FN SeenCell<Real> cell(const StepParams<Real>& params, const OwnParticle<Real>& own) const {
        const RigidBody& body = work.body[work.label[own.id]];
        const Quat<double> q = multiply(body.turned, work.start_rotation[own.id]);
        return {corners,
                {Real(q.x), Real(q.y), Real(q.z), Real(q.w)},
                body.starts != 0 ? params.carry_time : params.drift};
    }
    DEM_FN Turning<Real> operator()(const OwnParticle<Real>& own, const Pressed<Real>& at) const {
        const RigidBody& body = work.body[work.label[own.id]];
        const Sym3& j = body.inverse_inertia;
        const Vec3<double> seed = asDouble(xyz(own.state.position)) - body.centre,
                           arm = seed + asDouble(at.arm), normal = asDouble(at.normal),
                           lever = rotate(conjugate(body.turned), cross(arm, normal));
        const double contacts = body.contacts > 0 ? body.contacts : kContactsPerShare * body.least_stand,
                     standing = body.standing > 0 ? body.standing : kContactsPerShare * body.least_stand;
        const double diagonal = j.xx * j.xx + j.yy * j.yy + j.zz * j.zz;
        // At least the greatest principal value; of a ball the trace is 7.5 / (m R^2).
        const double norm = squareRoot(diagonal + 2 * (j.xy * j.xy + j.yz * j.yz + j.zx * j.zx));
        const double ball = 7.5 * body.inverse_mass / (j.xx + j.yy + j.zz);
        const double height = dot(arm, normal);
        const double far = squareRoot(length2(seed)) + double(own.constants.floor_radius);
        const double lies = height * height > ball ? ball / (height * height) : 1.0;
        return {Real(standShare(body) / body.contact_share) * own.constants.inverseMass(),
                Real(contacts * (body.inverse_mass + dot(lever, multiply(j, lever)))),
                own.constants.inverseMass(),
                Real(maxOf(standing, kFewestStanding) *
                     (body.inverse_mass + 0.5 * far * far * (j.xx + j.yy + j.zz))),
                Real(kRollingGrip / ((1.0 + body.contacts) * norm)),
                Real(kRollingRadiusShare * lies * squareRoot(ball))};
    }
};

template <bool kLedger, class Real, class Colliders, class Source = LooksItself<>>
DEM_FN RigidLoad<Real> collidersLoad(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                     const Colliders& colliders, const RigidWork& work,
                                     const OwnParticle<Real>& own, const OwnCorners<Real>& corners,
                                     const Source& source = {}) {
    RigidLoad<Real> load;
    if (!isNearColliders<StepKind::kContact>(params, colliders, own)) return load;
    forEachCollider(colliders, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
        const ColliderLoad<Real> at =
            colliderContact<kLedger>(arrays, params, colliders, own, c, bound, load.tally,
                                     TurnsFragment<Real, Source>{work, corners, source});
        add(load.push.wrench, counted(at.wrench, load.push.touching));
        load.push.coming += at.comes ? 1 : 0;
    });
    return load;
}

/// One thread a particle: the CPU.
template <bool kLedger, class Real>
struct GatherRigidLoad {
    SubstepArrays<Real> arrays;
    StepParams<Real> params;
    RigidWork work;
    Span<RigidLoadsOf<Real>> loads;  ///< by the particle's place in RigidWork::active

    DEM_FN void operator()(uint32_t place) const {
        const OwnParticle<Real> own = loadOwn(arrays, work.active[place]);
        RigidLoad<Real> rows;
        PartialSums<kPartials, Real> sums;
        const uint32_t first_bond = arrays.bond_row[own.id], last_bond = arrays.bond_row[own.id + 1];
        for (uint32_t slot = first_bond; slot < last_bond; ++slot)
            sums.add(slot - first_bond,
                     countedBondSlot<kLedger>(arrays, params, work.label[own.id], own, slot,
                                              bondFragment(arrays, work.label, slot), rows));
        const uint32_t first = arrays.contact_row[own.id], last = arrays.contact_row[own.id + 1];
        for (uint32_t slot = first; slot < last; ++slot)
            sums.add(slot - first,
                     countedContactSlot<kLedger>(arrays, params, work.label[own.id], own, slot,
                                                 contactFragment(arrays, work.label, slot), rows));
        rows.push.wrench = sums.total();
        loads[place].template keepRows<kLedger>(rows);
        loads[place].template keepColliders<kLedger>(collidersLoad<kLedger>(
            arrays, params, params.colliders, work, own, cornersOf(arrays.corners, own.id)));
    }
};

}  // namespace demolish
