// SPDX-License-Identifier: Apache-2.0
// What a rigid body that wakes has still to get of its last contact step. A velocity belongs to half a step
// before its moment: a body's to half a contact step, a particle's in substeps to half a substep. What acts
// on the body at the moment kicks it by the time between the two, or what presses would be lost.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {

/// Of each body that wakes: velocity and spin that it gets, in whole numbers of kVelocityUnit, so that the
/// order in which they are added does not matter.
struct PendingKicks {
    Span<const uint32_t> label, regime, former;  ///< per slot; `former`: before the decision
    Span<const RigidBody> body;                  ///< per slot
    Span<uint64_t> sums;                         ///< six a slot
    double time = 0;                             ///< s, between the two velocities; 0: nothing is pending

    DEM_FN bool wakes(uint32_t slot) const {
        return regime[slot] == wordOf(Regime::kBonded) && former[slot] == wordOf(Regime::kRigid);
    }
    /// It is moved with its bonds, as it was before.
    DEM_FN bool goesOn(uint32_t slot) const {
        return regime[slot] == wordOf(Regime::kBonded) && former[slot] == wordOf(Regime::kBonded);
    }
    /// It has gone a contact step. What is held is not moved by what is pending; what holds it takes that up.
    DEM_FN bool isPending(uint32_t slot) const { return time > 0 && wakes(slot) && body[slot].starts == 0; }
    /// One thread a slot, before any is added.
    DEM_FN void operator()(uint32_t slot) const {
        if (!wakes(slot)) return;
        for (uint32_t k = 0; k < 6; ++k) sums[6 * size_t{slot} + k] = 0;
    }
    /// Something pushes it.
    DEM_FN bool isKicked(uint32_t slot) const {
        if (!isPending(slot)) return false;
        for (uint32_t k = 0; k < 6; ++k)
            if (sums[6 * size_t{slot} + k] != 0) return true;
        return false;
    }
    DEM_FN Vec3<double> velocity(uint32_t slot) const { return sum(6 * size_t{slot}); }
    DEM_FN Vec3<double> spin(uint32_t slot) const { return sum(6 * size_t{slot} + 3); }
    /// N, N m; `arm`: m, from the body's centre.
    DEM_FN void add(uint32_t slot, const Vec3<double>& arm, const Vec3<double>& force,
                    const Vec3<double>& torque) const {
        const RigidBody& of = body[slot];
        const Vec3<double> turning = rotate(conjugate(of.turned), torque + cross(arm, force));
        addTo(6 * size_t{slot}, (time * of.inverse_mass) * force);
        addTo(6 * size_t{slot} + 3, time * rotate(of.turned, multiply(of.inverse_inertia, turning)));
    }

  private:
    DEM_FN Vec3<double> sum(size_t at) const {
        const auto value = [&](size_t k) { return kVelocityUnit * double(static_cast<int64_t>(sums[k])); };
        return {value(at), value(at + 1), value(at + 2)};
    }
    DEM_FN void addTo(size_t at, const Vec3<double>& change) const {
        const double value[3] = {change.x, change.y, change.z};
        for (uint32_t axis = 0; axis < 3; ++axis)
            atomicAddU64(&sums[at + axis],
                         static_cast<uint64_t>(static_cast<int64_t>(value[axis] / kVelocityUnit)));
    }
};

/// The particle's own orientation, into which its body has been brought.
template <class Real>
struct TurnsWithBody : TurnsFragment<Real> {
    DEM_FN SeenCell<Real> cell(const StepParams<Real>& params, const OwnParticle<Real>& own) const {
        return {this->corners, asQuat(own.state.rotation), params.drift};
    }
    DEM_FN Turning<Real> operator()(const OwnParticle<Real>& own, const Pressed<Real>& at) const {
        Turning<Real> turning = TurnsFragment<Real>::operator()(own, at);
        turning.damping = Real(0);
        return turning;
    }
};

/// Over what breaks a bond: faces that are found under such a load go on as soft as in a contact step. Less
/// is as little as the bond held.
inline constexpr double kUnseenLoad = 2;

/// One thread a particle or projectile slot, after PendingKicks has been cleared. Contacts with colliders are
/// those of a contact step: one that begins now takes in what it can bear there, or substeps would find its
/// overlap loaded with more than the body has brought. Of contacts with particles only those of two bodies
/// that wake count, and only what has been touching, or faces that begin likewise: to what goes on as it did
/// a body has given all that it got.
template <bool kLedger, class Real>
struct GatherPendingKick {
    SubstepArrays<Real> arrays;  ///< with the particles' own constants
    StepParams<Real> contact_step, substep;
    PendingKicks pending;
    RigidWork work;  ///< bodies and labels

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t slot = work.label[i];
        if (!(arrays.constants[i].takesPart())) return;
        if (pending.goesOn(slot)) return meetWoken(i);
        if (!pending.isPending(slot)) return;
        OwnParticle<Real> own = loadOwn(arrays, i);
        Tally<Real> tally;
        Wrench<Real> load = rowsLoad(own, tally);
        own.constants = shared(own);
        const ColliderSet<Real>& colliders = contact_step.colliders;
        forEachCollider(colliders, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
            add(load, colliderContact<kLedger>(arrays, contact_step, colliders, own, c, bound, tally,
                                               TurnsWithBody<Real>{{work, cornersOf(arrays.corners, i)}})
                          .wrench);
        });
        if (work.body[slot].isHeld()) return bookHeld(own, load, tally);
        if constexpr (kLedger) bookCarried(arrays, i, tally);
        if (!isNullWrench(load)) pending.add(slot, armOf(own), asDouble(load.force), asDouble(load.torque));
    }

  private:
    DEM_FN void bookHeld(const OwnParticle<Real>& own, const Wrench<Real>& load,
                         const Tally<Real>& tally) const {
        if constexpr (!kLedger) return;
        Vec4<Real>& ledger = arrays.ledger[own.id];
        bookLedger(ledger, tally, own.state, own.state, Real(pending.time));
        bookHold(ledger, load, own.state, own.state, Real(pending.time));
    }
    /// m, from the centre of its body.
    DEM_FN Vec3<double> armOf(const OwnParticle<Real>& of) const {
        return asDouble(xyz(of.state.position)) +
               asDouble(lowPart(of.state.position, of.state.velocity, of.state.spin)) -
               work.body[work.label[of.id]].centre;
    }
    /// Its constants in contact steps, if it has gone any.
    DEM_FN ParticleConstants<Real> shared(const OwnParticle<Real>& of) const {
        if (!pending.isPending(work.label[of.id])) return of.constants;
        const RigidBody& body = work.body[work.label[of.id]];
        return sharedConstants(body, rotate(conjugate(body.turned), armOf(of)), of.constants);
    }
    DEM_FN Wrench<Real> rowsLoad(const OwnParticle<Real>& own, Tally<Real>& tally) const {
        Wrench<Real> load;
        for (uint32_t s = arrays.bond_row[own.id]; s < arrays.bond_row[own.id + 1]; ++s) {
            const LinkEnd end = linkEnd(arrays, s);
            if (isBonded(end.link)) continue;
            if (pending.goesOn(work.label[end.id])) beginSoft(own, s, end);
            if (!isShared(own.id, end.id)) continue;
            if (facesBegin(own, s, end)) {
                add(load, newFaces(own, s, end, tally));
                continue;
            }
            add(load, untouched(arrays.bond_spring[s], tally, [&](Tally<Real>& booked) {
                    return formerBondSlot<kLedger>(arrays, substep, own, s, end, booked);
                }));
        }
        for (uint32_t s = arrays.contact_row[own.id]; s < arrays.contact_row[own.id + 1]; ++s) {
            if (!isShared(own.id, arrays.neighbour[s])) continue;
            add(load, untouched(arrays.contact_spring[s], tally, [&](Tally<Real>& booked) {
                    return contactSlot<kLedger>(arrays, substep, own, s, contactEnd(arrays, s), booked);
                }));
        }
        return load;
    }
    /// Of a particle that goes on as it did.
    DEM_FN void meetWoken(uint32_t i) const {
        for (uint32_t s = arrays.bond_row[i]; s < arrays.bond_row[i + 1]; ++s) {
            const LinkEnd end = linkEnd(arrays, s);
            if (!isBonded(end.link) && pending.isPending(work.label[end.id]))
                beginSoft(loadOwn(arrays, i), s, end);
        }
    }
    /// Faces of one that goes on as it did and one that wakes: substeps have seen that half a contact step
    /// back, where the two were apart.
    DEM_FN void beginSoft(const OwnParticle<Real>& own, uint32_t s, const LinkEnd& end) const {
        Tally<Real> unbooked;
        if (facesBegin(own, s, end)) newFaces(own, s, end, unbooked);
    }
    /// Faces of a broken bond that the last contact step has pressed on each other, and that nothing has seen
    /// touch yet.
    DEM_FN bool facesBegin(const OwnParticle<Real>& own, uint32_t s, const LinkEnd& end) const {
        if (pairState(end.link) != PairState::kBroken || !holdsNothing(arrays.bond_spring[s])) return false;
        const LoadedState<Real> there = loadWithoutRotation(arrays.in, arrays.in.position[end.id], end.id);
        const Real length_now = length(separation(own.state, there));
        const BondConstants<Real> bond =
            bondConstants(arrays.rest[s], end.link.grade, arrays.body_laws[own.owner]);
        const Real load =
            brokenRepulsion(bond.stiffness.normal, brokenOverlap(length(bond.rest), length_now));
        return load > Real(kUnseenLoad * kPi) * bond.strength * (bond.radius * bond.radius);
    }
    /// They begin as in a contact step.
    DEM_FN Wrench<Real> newFaces(const OwnParticle<Real>& own, uint32_t s, const LinkEnd& end,
                                 Tally<Real>& tally) const {
        OwnParticle<Real> here = own, there = loadOwn(arrays, end.id);
        here.constants = shared(here);
        there.constants = shared(there);
        const FormerBond<Real> faces{
            s, end.link, there.state, there.constants, arrays.rest[s], arrays.bond_spring[s]};
        return touchingFormerBond<kLedger, StepKind::kContact>(arrays, contact_step, here, faces, tally);
    }
    /// Of two bodies that both wake.
    DEM_FN bool isShared(uint32_t i, uint32_t j) const {
        return work.label[j] != work.label[i] && pending.isPending(work.label[j]);
    }
    /// What `touch` gives of a slot that holds something, which stays as it was unless it parts.
    template <class Touch>
    DEM_FN static Wrench<Real> untouched(Vec4<Real>& slot, Tally<Real>& tally, const Touch& touch) {
        const Vec4<Real> kept = slot;
        if (holdsNothing(kept)) return {};
        Tally<Real> booked;
        const Wrench<Real> load = touch(booked);
        if (!holdsNothing(slot)) {
            slot = kept;
            booked.spring_energy = booked.contact_loss = Real(0);
        }
        tally += booked;
        return load;
    }
};

}  // namespace demolish
