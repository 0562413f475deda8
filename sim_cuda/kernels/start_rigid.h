// SPDX-License-Identifier: Apache-2.0
// From particles to rigid bodies and back: the body that fits a fragment's present motion by (16)-(18), where
// its particles hang on it, and the particles put where it has taken them.
#pragma once
#include "sim_cuda/kernels/islands.h"
#include "sim_cuda/kernels/pending_kick.h"
#include "sim_cuda/kernels/rigid_step.h"

namespace demolish {

/// One thread a slot that is not moved with its bonds, or wakes: its body, from the fit of the moment. Within
/// a frame bodies go on as they are; only projectiles, which may be new, start again.
template <class Real>
struct StartBodies {
    FragmentRows rows;
    Span<const uint32_t> label, regime, former;
    Span<BodyMemory> memory;  ///< per slot, of the last step; of one that begins: what it begins with
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const RigidMotion> motion;  ///< per slot of a body's fragment
    Span<const PoseSums> pose;       ///< by place
    Span<const SpinSums> spin;       ///< by place
    Span<RigidBody> body;
    uint32_t in_bodies = 0;
    bool frame_starts = false;
    HoldsIn holds{};

    DEM_FN void operator()(uint32_t slot) const {
        const bool is_bonded = regime[slot] == wordOf(Regime::kBonded);
        if (label[slot] != slot || (is_bonded && former[slot] != wordOf(Regime::kRigid))) return;
        if (!frame_starts && (is_bonded || slot < in_bodies)) return;
        if (slot < in_bodies) {
            store(body[slot], holds.hold(slot) ? ofHeld(slot) : ofFragment(slot));
        } else {
            if (!(constants[slot].takesPart())) return;
            store(body[slot], ofProjectile(slot));
        }
        body[slot].starts = former[slot] == wordOf(Regime::kBonded) ? 1 : 0;
        const BodyMemory last = former[slot] == wordOf(Regime::kRigid) ? memory[slot] : memoryOf({});
        memory[slot] = last;
        body[slot].flight = rememberedFlight(last);
        countContacts(body[slot], rememberedContacts(last), last.standing);
    }

  private:
    DEM_FN RigidBody ofFragment(uint32_t slot) const {
        const RigidMotion fit = motion[slot];
        RigidBody start;
        start.centre = fit.centre;
        start.velocity = fit.velocity;
        start.spin = fit.spin;
        start.angular = spin[rows.first[slot]].angular;
        start.inverse_inertia = inverted(spin[rows.first[slot]].inertia);
        start.inverse_mass = 1 / pose[rows.first[slot]].now.mass;
        start.least_share = leastShare(rows.size[slot]);
        start.least_stand = leastStand(rows.size[slot]);
        return start;
    }
    /// It hangs on the lowest of what is held of it, and nothing pushes it.
    DEM_FN RigidBody ofHeld(uint32_t slot) const {
        const uint32_t leader = holds.leader[slot];
        RigidBody start;
        start.centre = exactPosition(state, leader);
        start.velocity = asDouble(xyz(state.velocity[leader]));
        start.spin = asDouble(xyz(state.spin[leader]));
        start.least_share = leastShare(rows.size[slot]);
        start.least_stand = leastStand(rows.size[slot]);
        return start;
    }
    DEM_FN RigidBody ofProjectile(uint32_t slot) const {
        RigidBody start;
        start.centre = exactPosition(state, slot);
        start.velocity = asDouble(xyz(state.velocity[slot]));
        start.spin = asDouble(xyz(state.spin[slot]));
        const double inverse = double(constants[slot].inverse_inertia);
        start.angular = (1 / inverse) * start.spin;
        start.inverse_inertia = {inverse, inverse, inverse, 0, 0, 0};
        start.inverse_mass = double(constants[slot].inverseMass());
        start.least_share = kLeastShare;
        start.least_stand = kLeastShare;
        return start;
    }
};

/// One thread a particle of a body, before clustering: every one of them may be the slot of a piece. It goes
/// on in the regime and the flight of what it was part of, and has not rested yet.
struct SplitRigid {
    Span<const uint32_t> label, owner;
    Span<const uint32_t> splits;  ///< per body: 1 of those that come apart
    Span<uint32_t> regime;
    Span<BodyMemory> memory;
    Span<CalmClock> clock;

    DEM_FN void operator()(uint32_t i) const {
        if (splits[owner[i]] == 0) return;
        clock[i] = {};
        const uint32_t slot = label[i];
        if (slot == i) return;
        regime[i] = regime[slot];
        memory[i] = memory[slot];
    }
};

/// J of a particle's translation and spin.
DEM_FN double kineticEnergy(double mass, double inertia, const Vec3<double>& v, const Vec3<double>& w) {
    return 0.5 * (mass * length2(v) + inertia * length2(w));
}

/// One thread a particle or projectile slot, of which the latter alone within a frame. Whatever is not moved
/// with its bonds stands in both instants of the state; what vibration a fragment had when its bonds came to
/// rest, and what speed when it fell asleep, is booked as damping.
template <class Real>
struct SettleRegimes {
    StateIn<Real> in;
    StateOut<Real> state, other;  ///< the memory behind `in`; the other instant
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> label, regime, former;
    Span<const BodyMemory> memory;  ///< per slot, of the last step: bodies themselves are in no snapshot
    Span<const RigidBody> body;
    Span<Vec3<double>> arm;
    Span<Quat<double>> start_rotation;
    Span<Vec4<Real>> ledger;
    PendingKicks pending;        ///< of those that wake,
    SubstepArrays<Real> arrays;  ///< and what is booked of it
    Span<Vec4<Real>> start;      ///< FragmentVelocities::start
    Vec3<double> gravity;        ///< m/s^2
    double substep = 0;          ///< s
    uint32_t in_bodies = 0;
    bool frame_starts = false;

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t slot = label[i], now = regime[slot];
        const bool wakes = pending.wakes(slot);
        if (!frame_starts && i < in_bodies && !wakes) return;
        if (wakes) catchUp(i, slot);
        if (now != wordOf(Regime::kBonded)) hang(i, slot);
        if (now == wordOf(Regime::kAsleep) && former[slot] != now) stop(i);
        copyState(i);
    }

  private:
    DEM_FN void hang(uint32_t i, uint32_t slot) const {
        const RigidBody fit = body[slot];
        const Vec3<double> from_centre = exactPosition(in, i) - fit.centre;
        arm[i] = from_centre;
        const Vec4<Real> rotation = in.rotation[i];
        start_rotation[i] = {double(rotation.x), double(rotation.y), double(rotation.z), double(rotation.w)};
        if (regime[slot] != wordOf(Regime::kRigid)) return;
        const bool hung = former[slot] == wordOf(Regime::kBonded);
        setMotion(i, hung, velocityAt(fit.velocity, fit.spin, from_centre), fit.spin);
        if (hung && fit.isHeld()) carryFromNow(i);
    }
    /// Substeps see what a path leads from half a contact step before its moment on. What they have moved
    /// themselves until now, and pressed against, they must not see spring back: as if it had stood until
    /// now.
    DEM_FN void carryFromNow(uint32_t i) const {
        if (arrays.led_from.empty()) return;
        arrays.led_from[2 * size_t{i}] = withW(-xyz(state.velocity[i]), Real(0));
        arrays.led_from[2 * size_t{i} + 1] = withW(-xyz(state.spin[i]), Real(0));
    }
    DEM_FN void stop(uint32_t i) const { setMotion(i, true, {}, {}); }
    /// What the last contact step has not given yet: gravity to what has fallen freely, and all to what a
    /// kick is pending for.
    DEM_FN void catchUp(uint32_t i, uint32_t slot) const {
        if (!(constants[i].takesPart()) || constants[i].isHeld()) return;
        const Flight flight = rememberedFlight(memory[slot]);
        const bool kicked = pending.isKicked(slot);
        if (flight.free == 0 && !kicked) return;
        const LoadedState<Real> before = loadState(in, i);
        const Vec3<double> gained = kicked ? pending.velocity(slot) : Vec3<double>{},
                           turn = kicked ? pending.spin(slot) : Vec3<double>{},
                           from_centre = kicked ? exactPosition(in, i) - body[slot].centre : Vec3<double>{};
        const Vec3<double> fallen = axpy(0.5 * flight.lag * substep, gravity, asDouble(xyz(before.velocity)));
        const Vec3<double> v = fallen + velocityAt(gained, turn, from_centre),
                           w = asDouble(xyz(before.spin)) + turn;
        state.velocity[i] = withLowOf(Vec3<Real>{Real(v.x), Real(v.y), Real(v.z)}, before.velocity);
        state.spin[i] = withLowOf(Vec3<Real>{Real(w.x), Real(w.y), Real(w.z)}, before.spin);
        if (i == slot)
            bookedDamping(ledger[i]) -= Real(gainOf(slot, gained, turn, 0.5 * flight.lag * substep));
        if (!kicked) return;
        bookKick(i, before, loadState(in, i));
        if (i == slot && i < in_bodies)
            start[slot] = withW(xyz(start[slot]) + Vec3<Real>{Real(gained.x), Real(gained.y), Real(gained.z)},
                                start[slot].w);
    }

    /// What the pending kick dissipates; what rubs is no part of gainOf().
    DEM_FN void bookKick(uint32_t i, const LoadedState<Real>& before, const LoadedState<Real>& after) const {
        const Tally<Real> tally = takeCarriedTally(arrays, i);
        bookLedger(ledger[i], tally, before, after, Real(pending.time));
        Wrench<Real> spent = tally.damping;
        add(spent, tally.friction);
        const Real power = powerAt(Real(1), spent, before, after) - powerAt(Real(0), spent, before, after);
        bookedDamping(ledger[i]) += Real(0.5 * (pending.time + substep)) * power;
    }
    /// J: of what acts leapfrog keeps the more the shorter its steps are (StepRigid::stretchLoss). `gained`,
    /// `turn`: by what pushes; `fall`: s for which gravity pulls.
    DEM_FN double gainOf(uint32_t slot, const Vec3<double>& gained, const Vec3<double>& turn,
                         double fall) const {
        const RigidBody& woken = body[slot];
        const double mass = 1 / woken.inverse_mass;
        const Vec3<double> change = axpy(fall, gravity, gained);
        const double weight = (0.5 * (fall + substep) * mass) * dot(gravity, change);
        if (!(pending.time > 0)) return weight;
        const Vec3<double> in_body = rotate(conjugate(woken.turned), turn);
        const double pushed =
            mass * dot(gained, change) + dot(in_body, multiply(inverted(woken.inverse_inertia), in_body));
        return weight + 0.5 * (1 + substep / pending.time) * pushed;
    }

    DEM_FN void setMotion(uint32_t i, bool book, const Vec3<double>& v, const Vec3<double>& w) const {
        if (!(constants[i].takesPart())) return;
        book = book && !constants[i].isHeld();
        const double mass = 1 / double(constants[i].inverseMass()),
                     inertia = 1 / double(constants[i].inverse_inertia);
        const double before =
            kineticEnergy(mass, inertia, asDouble(xyz(in.velocity[i])), asDouble(xyz(in.spin[i])));
        if (book) bookedDamping(ledger[i]) += Real(before - kineticEnergy(mass, inertia, v, w));
        state.velocity[i] = withLowOf(Vec3<Real>{Real(v.x), Real(v.y), Real(v.z)}, in.velocity[i]);
        state.spin[i] = withLowOf(Vec3<Real>{Real(w.x), Real(w.y), Real(w.z)}, in.spin[i]);
    }
    DEM_FN void copyState(uint32_t i) const {
        other.position[i] = state.position[i];
        other.rotation[i] = state.rotation[i];
        other.velocity[i] = state.velocity[i];
        other.spin[i] = state.spin[i];
    }
};

/// One thread a particle or projectile slot: all of a rigid fragment, not only what may touch.
template <class Real>
struct PlaceRigid {
    Span<const uint32_t> label, regime;
    Span<const RigidBody> body;
    Span<const Vec3<double>> arm;
    Span<const Quat<double>> start_rotation;
    StateOut<Real> state, other;

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t slot = label[i];
        if (regime[slot] != wordOf(Regime::kRigid)) return;
        const RigidBody moved = body[slot];
        if (moved.stands()) return;
        const Vec3<double> from_centre = rotate(moved.turned, arm[i]);
        const Vec3<double> x = moved.centre + from_centre,
                           v = velocityAt(moved.velocity, moved.spin, from_centre);
        placeParticle(state, i, x, v, moved.spin);
        placeParticle(other, i, x, v, moved.spin);
        const Quat<double> q = normalized(multiply(moved.turned, start_rotation[i]));
        state.rotation[i] = other.rotation[i] = {Real(q.x), Real(q.y), Real(q.z), Real(q.w)};
    }
};

}  // namespace demolish
