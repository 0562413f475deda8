// SPDX-License-Identifier: Apache-2.0
// One contact step of a rigid fragment: the loads of its particles in a fixed order, kick and drift of the
// whole, then the particles put where it has taken them. Lanes share a fragment, on the GPU as threads;
// whatever runs them, place k of its row belongs to lane k mod laneCount(), and lanes are added as a tree.
#pragma once
#include "sim_cuda/kernels/fragment_sums.h"
#include "sim_cuda/kernels/integrate.h"
#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {

/// Lanes of a long row.
inline constexpr uint32_t kRigidLanes = 256;

/// Lanes that share a row of so many places: a power of two, so that a short row needs no long tree.
DEM_FN uint32_t laneCount(uint32_t places) {
    uint32_t lanes = 1;
    while (lanes < places && lanes < kRigidLanes) lanes *= 2;
    return lanes;
}

/// About the fragment's centre.
struct RigidSums {
    Vec3<double> force, torque;  ///< N, N m
    uint32_t touching = 0;       ///< contacts that give it,
    uint32_t standing = 0;       ///< and how many of them with colliders
    uint32_t coming = 0;         ///< contacts with colliders that the next step will bring
};
DEM_FN void add(RigidSums& into, const RigidSums& other) {
    into.force = into.force + other.force;
    into.torque = into.torque + other.torque;
    into.touching += other.touching;
    into.standing += other.standing;
    into.coming += other.coming;
}

/// A state in double as the particles' arrays hold it.
template <class Real>
DEM_FN void placeParticle(const StateOut<Real>& out, uint32_t i, const Vec3<double>& x, const Vec3<double>& v,
                          const Vec3<double>& w) {
    const Vec3<Real> high{Real(x.x), Real(x.y), Real(x.z)};
    const Vec3<Real> low{Real(x.x - double(high.x)), Real(x.y - double(high.y)), Real(x.z - double(high.z))};
    out.position[i] = withW(high, low.x);
    out.velocity[i] = withW(Vec3<Real>{Real(v.x), Real(v.y), Real(v.z)}, low.y);
    out.spin[i] = withW(Vec3<Real>{Real(w.x), Real(w.y), Real(w.z)}, low.z);
}

/// Contacts among which the mass of a fragment of `particles` is shared at least, and of a projectile.
inline constexpr uint32_t kLeastShare = 4;

/// A flat landing brings many contacts in one step. A contact that became softer with each of them would lose
/// what it holds, and what had met the first ones stiffer than so many allow would be thrown back: so many
/// are counted upon, the root of the particles, whether they touch or not.
DEM_FN uint32_t leastShare(uint32_t particles) {
    uint32_t root = kLeastShare;
    while ((root + 1) * (root + 1) <= particles) ++root;
    return root;
}

/// Contacts with colliders of a flat landing: the particles of a face, or nearly so.
DEM_FN double contactsOfFace(uint32_t particles) {
    const double root = squareRoot(double(particles));
    return root * squareRoot(squareRoot(root));
}
/// Contacts with colliders among which the mass of a fragment of so many particles is shared at least.
inline constexpr double kLeastStand = 1;
DEM_FN double leastStand(uint32_t particles) {
    return maxOf(kLeastStand, contactsOfFace(particles) / kContactsPerShare);
}

/// The mass of the fragment is shared among them from now on. `standing`: those with colliders.
DEM_FN void countContacts(RigidBody& body, uint32_t contacts, uint32_t standing) {
    const uint32_t wanted = contacts / kContactsPerShare;
    body.contacts = contacts;
    body.standing = standing;
    body.contact_share = wanted > body.least_share ? wanted : body.least_share;
}

/// Each contact stands for what the fragment sets against it there, over all its contacts of the step before:
/// its mass and, across the arm to the particle, its turning, so that the step is stable however many touch,
/// be it at the tip of a splinter. Its damper is that of a substep and goes by the particle's own mass
/// (`OwnMass`) but where it hardly approaches (`kRestApproach`), and so does what resists rolling but on
/// colliders (`TurnsFragment`). `arm`: m, from the centre, in the frame that the inertia belongs to.
template <class Real>
DEM_FN ParticleConstants<Real> sharedConstants(const RigidBody& body, const Vec3<double>& arm,
                                               const ParticleConstants<Real>& own) {
    if (body.isHeld())
        return {Real(kHeldInverseMass), own.inverseMass(), own.contact_radius, Real(kHeldReach)};
    const Sym3& j = body.inverse_inertia;
    const double trace = j.xx + j.yy + j.zz;
    const double turning = 0.5 * (length2(arm) * trace - dot(arm, multiply(j, arm)));
    return {Real(double(body.contact_share) * (body.inverse_mass + turning)), own.inverseMass(),
            own.contact_radius, own.floor_radius};
}

/// The same in substeps that carry the particle on. Rolling resistance there takes what it takes of the
/// particle alone, or of the fragment's share where that turns more easily. No contact is stiffer than with
/// the particle's own mass (pairInertia, softestOfPair).
template <class Real>
DEM_FN ParticleConstants<Real> carriedConstants(const RigidBody& body, const ParticleConstants<Real>& shared,
                                                const ParticleConstants<Real>& own) {
    const Sym3& j = body.inverse_inertia;
    const Real share = Real(double(body.contact_share) * (j.xx + j.yy + j.zz)),
               heaviest = own.inverseMass() / Real(kRigidStride * kRigidStride);
    const ParticleConstants<Real> carried{maxOf(shared.inverseMass(), heaviest),
                                          maxOf(share, own.inverse_inertia / Real(kRigidStride)),
                                          shared.contact_radius, shared.floor_radius};
    return carried.seenByOther();
}

/// A rigid fragment: its slot and its places in RigidWork::active.
struct RigidRow {
    uint32_t slot, first, last;
    DEM_FN uint32_t places() const { return last - first; }
};
/// What stands at a place, and does not change from step to step.
template <class Real>
struct RigidSeat {
    uint32_t place, particle;
    Vec3<double> arm;
    ParticleConstants<Real> own;
};

template <bool kLedger, class Real>
struct StepRigid {
    SubstepArrays<Real> arrays;  ///< `in` and `out` are both brought up to date
    StateOut<Real> state;        ///< the memory behind arrays.in
    StepParams<Real> params;     ///< of a substep
    RigidWork work;
    Span<const RigidLoadsOf<Real>> loads;       ///< by the place in RigidWork::active
    Span<ParticleConstants<Real>> constants;    ///< those that contact steps use,
    Span<ParticleConstants<Real>> in_substeps;  ///< and those of carried particles, if any, in substeps
    Span<const ParticleConstants<Real>> own_constants;
    uint32_t previous = kRigidStride,
             stride = kRigidStride;  ///< substeps in the step before, and in this one
    double carried_share = 0;  ///< of what carried particles felt in the substeps: 1 / their number; 0: none

    /// s for which what touches pushes.
    DEM_FN double push() const { return pushedSubsteps(previous, stride) * double(params.dt); }
    DEM_FN RigidRow row(uint32_t entry) const {
        return {work.fragment[entry], work.first[entry], work.last[entry]};
    }
    /// At a place of the row, or in its first one if it has not so many.
    DEM_FN RigidSeat<Real> seat(const RigidRow& row, uint32_t k) const {
        const uint32_t place = row.first + (k < row.places() ? k : 0), i = work.active[place];
        return {place, i, work.arm[i], own_constants[i]};
    }
    /// `seat`: at the lane's first place, seat(row, lane).
    DEM_FN RigidSums gather(const RigidBody& body, const RigidRow& row, RigidSeat<Real> seat, uint32_t lane,
                            uint32_t lanes) const {
        RigidSums sums;
        for (uint32_t k = lane; k < row.places(); k += lanes) {
            if (k != lane) seat = this->seat(row, k);
            const Wrench<Real> felt = carried(seat.particle);
            const RigidPush<Real> load = loads[seat.place].push();
            sums.coming += load.coming;
            if (isNullWrench(load.wrench) && isNullWrench(felt)) continue;
            const Vec3<double> force = axpy(carried_share, asDouble(felt.force), asDouble(load.wrench.force));
            const Vec3<double> torque =
                axpy(carried_share, asDouble(felt.torque), asDouble(load.wrench.torque));
            const Vec3<double> arm = rotate(body.turned, seat.arm);
            add(sums, {force, torque + cross(arm, force), load.touching, loads[seat.place].standing(), 0});
        }
        return sums;
    }
    /// Added up over the substeps.
    DEM_FN Wrench<Real> carried(uint32_t i) const {
        if (!(carried_share > 0)) return {};
        return {xyz(arrays.carried[2 * size_t{i}]), xyz(arrays.carried[2 * size_t{i} + 1])};
    }
    /// J that gravity's work loses by the change of steps (stretchLoss()), for the ledger.
    DEM_FN double move(RigidBody& body, const RigidSums& total) const {
        const double substep = double(params.dt);
        body.starts = 0;
        if (body.isHeld()) {
            lead(body, stride * substep);
            countContacts(body, total.touching, total.standing);
            return 0;
        }
        const double pulled = substep * (body.flight.lag + 1.0),
                     fallen = substep * fallenSubsteps(body.flight, previous, stride, total.touching > 0);
        if (isLight(body.inverse_mass * total.force)) body.flight.free = 1;
        const Vec3<double> before = body.velocity, gravity = asDouble(params.gravity);
        advance(body, push() * total.force, push() * total.torque, fallen * gravity, stride * substep);
        countContacts(body, total.touching + total.coming, total.standing + total.coming);
        return 0.5 * (fallen - pulled) / body.inverse_mass * dot(gravity, body.velocity - before);
    }
    /// What touches gives less than half of what gravity does (m/s^2): the body falls on.
    DEM_FN bool isLight(const Vec3<double>& given) const {
        return length2(given) < 0.25 * length2(asDouble(params.gravity));
    }
    /// For one lane, that of the first place, which is the slot's if that is active. `lost`: of move().
    DEM_FN void keep(const RigidBody& body, const RigidRow& row, double lost) const {
        store(work.body[row.slot], body);
        work.memory[row.slot] = memoryOf(body);
        if constexpr (kLedger) bookedDamping(arrays.ledger[row.slot]) += Real(lost);
    }
    /// Every `lanes`-th particle from `lane` on, however many lanes there are; `seat` as in gather().
    DEM_FN void place(const RigidBody& body, const RigidRow& row, RigidSeat<Real> seat, uint32_t lane,
                      uint32_t lanes) const {
        for (uint32_t k = lane; k < row.places(); k += lanes) {
            if (k != lane) seat = this->seat(row, k);
            const uint32_t i = seat.particle;
            const LoadedState<Real> before = loadWithoutRotation(arrays.in, arrays.in.position[i], i);
            const Vec3<double> arm = rotate(body.turned, seat.arm);
            const Vec3<double> x = body.centre + arm, v = velocityAt(body.velocity, body.spin, arm);
            if (!body.stands()) {
                placeParticle(state, i, x, v, body.spin);
                placeParticle(arrays.out, i, x, v, body.spin);
            }
            const ParticleConstants<Real> shared = sharedConstants(body, seat.arm, seat.own);
            constants[i] = shared;
            if (carried_share > 0) in_substeps[i] = carriedConstants(body, shared, seat.own);
            if constexpr (kLedger) bookPushes(body, seat, before);
            if (body.isHeld()) forgetHowItWasLed(arrays, i);
            if (carried_share > 0)
                arrays.carried[2 * size_t{i}] = arrays.carried[2 * size_t{i} + 1] = Vec4<Real>{};
        }
    }
    /// Of a held body its work, too. What it carries has been felt from half a step before the moment on.
    DEM_FN void bookPushes(const RigidBody& body, const RigidSeat<Real>& seat,
                           const LoadedState<Real>& now) const {
        const uint32_t i = seat.particle;
        const LoadedState<Real> after = afterKick(body, seat, now);
        const auto book = [&](Real share, const Wrench<Real>& load, const Tally<Real>& tally,
                              const LoadedState<Real>& before) {
            const Real time = share * Real(push());
            bookLedger(arrays.ledger[i], tally, before, after, time);
            if (body.isHeld())
                bookHold(arrays.ledger[i], load, before, after, time);
            else
                bookedDamping(arrays.ledger[i]) += share * stretchLoss(load, tally, before, after);
        };
        book(Real(1), loads[seat.place].push().wrench, loads[seat.place].tally(),
             body.isHeld() ? beforeItWasLed(arrays, i, now, formerShare()) : now);
        if (carried_share > 0)
            book(Real(carried_share), carried(i), takeCarriedTally(arrays, i),
                 body.isHeld() ? beforeItWasLed(arrays, i, now) : now);
    }
    /// Of push(), what belongs to the time before the step, doubled.
    DEM_FN Real formerShare() const { return Real(previous / pushedSubsteps(previous, stride)); }
    /// J: what leapfrog keeps is half the mass times the velocities before and after a kick (physics B.1).
    /// Where a step is longer than the one before it, it keeps less of what pushes, and more where it is
    /// shorter: the half of their difference times the half of what the elastic part of the load gives.
    DEM_FN Real stretchLoss(const Wrench<Real>& load, const Tally<Real>& tally,
                            const LoadedState<Real>& before, const LoadedState<Real>& after) const {
        Wrench<Real> elastic = load;
        add(elastic, {-tally.damping.force, -tally.damping.torque});
        add(elastic, {-tally.friction.force, -tally.friction.torque});
        const Real power =
            powerAt(Real(1), elastic, before, after) - powerAt(Real(0), elastic, before, after);
        return Real(0.25) * (Real(stride) - Real(previous)) * params.dt * power;
    }
    /// What a kick gives and takes needs the velocity right after it, before drift and turn have changed arm
    /// and spin.
    DEM_FN LoadedState<Real> afterKick(const RigidBody& body, const RigidSeat<Real>& seat,
                                       const LoadedState<Real>& before) const {
        const Vec3<double> w = body.isHeld() ? body.spin : spinAt(body, body.kicked),
                           v = velocityAt(body.velocity, w, rotate(body.kicked, seat.arm));
        LoadedState<Real> after = before;
        after.velocity = withLowOf(Vec3<Real>{Real(v.x), Real(v.y), Real(v.z)}, before.velocity);
        after.spin = withLowOf(Vec3<Real>{Real(w.x), Real(w.y), Real(w.z)}, before.spin);
        return after;
    }
    /// The CPU: all lanes of a fragment in turn.
    DEM_FN void operator()(uint32_t entry) const {
        const RigidRow row = this->row(entry);
        RigidBody body = work.body[row.slot];
        RigidSums sums[kRigidLanes];
        const uint32_t lanes = laneCount(row.places());
        for (uint32_t lane = 0; lane < lanes; ++lane)
            sums[lane] = gather(body, row, seat(row, lane), lane, lanes);
        for (uint32_t step = lanes / 2; step > 0; step /= 2)
            for (uint32_t lane = 0; lane < step; ++lane) add(sums[lane], sums[lane + step]);
        keep(body, row, move(body, sums[0]));
        place(body, row, seat(row, 0), 0, 1);
    }
};

}  // namespace demolish
