// SPDX-License-Identifier: Apache-2.0
// Leapfrog, kick then drift (physics B.1), and the ledger's share of a particle.
#pragma once
#include "sim_cuda/data/ledger.h"
#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/physics/chance_rounding.h"

namespace demolish {

/// hi + lo + change as a new unevaluated sum (compensated addition).
template <class Real>
DEM_FN void addToPosition(Real change, Real& high, Real& low) {
    const Real step = low + change, sum = high + step;
    low = step - (sum - high);
    high = sum;
}

/// Nobody moves it; or it is held, and not led anywhere.
template <class Real>
DEM_FN bool stands(const OwnParticle<Real>& own) {
    if (!own.constants.isMovedHere()) return true;
    return own.constants.isHeld() &&
           !(length2(xyz(own.state.velocity)) + length2(xyz(own.state.spin)) > Real(0));
}

/// Last digits of a velocity that a substep at 1 g changes it by at least where it is rounded to the nearest:
/// less, and a ball that slides for seconds in steps of a microsecond hardly feels its friction.
inline constexpr double kDigitsSeen = 64, kOneG = 9.81;

/// Who may be moved: a kernel that moves no projectile is without what only those need.
enum class Movable : uint32_t { kAll, kBodies };

/// A projectile so fast, and substeps so short, that what friction takes is lost in rounding.
template <Movable kMovable, class Real>
DEM_FN bool losesDigits(const OwnParticle<Real>& own, const StepParams<Real>& params) {
    if (kMovable == Movable::kBodies || own.id < params.in_bodies) return false;
    const Vec4<Real>& v = own.state.velocity;
    const Real most = maxOf(maxOf(absOf(v.x), absOf(v.y)), absOf(v.z));
    return Real(kOneG) * params.dt < Real(kDigitsSeen) * lastDigit(most);
}
/// `index`: the first of three chances, which the state decides.
template <class Real>
DEM_FN Vec3<Real> addedByChance(const LoadedState<Real>& state, uint64_t index, const Vec3<Real>& value,
                                const Vec3<Real>& change) {
    const uint64_t seed = std::bit_cast<uint32_t>(float(state.position.w)) |
                          uint64_t{std::bit_cast<uint32_t>(float(state.spin.w))} << 32;
    const uint64_t turn = index + 8 * uint64_t{std::bit_cast<uint32_t>(float(state.rotation.x))};
    return {addedByChance(value.x, change.x, Real(uniformOf(seed, turn))),
            addedByChance(value.y, change.y, Real(uniformOf(seed, turn + 1))),
            addedByChance(value.z, change.z, Real(uniformOf(seed, turn + 2)))};
}

/// v += dt f/m, w += dt tau/I, x += dt v, q <- exp(dt w/2) q. What is held is not kicked, and what stands
/// stays to the last bit.
template <Movable kMovable, class Real>
DEM_FN LoadedState<Real> kickAndDrift(const OwnParticle<Real>& own, const Wrench<Real>& load,
                                      const StepParams<Real>& params) {
    LoadedState<Real> next = own.state;
    if (stands(own)) return next;
    const Real dt = params.dt, keep = params.velocity_keep;
    const bool free = !own.constants.isHeld();
    const Vec3<Real> acceleration = axpy(own.constants.inverseMass(), load.force, params.gravity);
    const Real turning = dt * own.constants.inverse_inertia;
    const bool by_chance = losesDigits<kMovable>(own, params);
    const Vec3<Real> v = xyz(own.state.velocity), w = xyz(own.state.spin);
    const Vec3<Real> kicked =
        keep * (by_chance ? addedByChance(own.state, 0, v, dt * acceleration) : axpy(dt, acceleration, v));
    const Vec3<Real> turned = keep * (by_chance ? addedByChance(own.state, 3, w, turning * load.torque)
                                                : axpy(turning, load.torque, w));
    const Vec3<Real> velocity = free ? kicked : v;
    const Vec3<Real> spin = free ? turned : w;
    Vec3<Real> low = lowPart(own.state.position, own.state.velocity, own.state.spin);
    addToPosition(dt * velocity.x, next.position.x, low.x);
    addToPosition(dt * velocity.y, next.position.y, low.y);
    addToPosition(dt * velocity.z, next.position.z, low.z);
    next.velocity = withLowOf(velocity, next.velocity);
    next.spin = withLowOf(spin, next.spin);
    setLowPart(next, low);
    next.rotation = asVec4(advanced(asQuat(own.state.rotation), spin, dt));
    return next;
}

template <class Real>
DEM_FN void storeState(const StateOut<Real>& out, uint32_t i, const LoadedState<Real>& state) {
    out.position[i] = state.position;
    out.rotation[i] = state.rotation;
    out.velocity[i] = state.velocity;
    out.spin[i] = state.spin;
}

/// m/s: what a carried particle moves by beside its velocity, where a path has changed that since the last
/// contact step. Until the moment of the step it goes by the former one, which its first substep, half a step
/// back, has in full; the others go on along the mean of both.
template <class Real>
DEM_FN Vec3<Real> carriedLed(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, uint32_t i) {
    const Real share = params.carry_time != params.dt ? Real(1) : Real(0.5);
    return arrays.led_from.empty() ? Vec3<Real>{} : share * xyz(arrays.led_from[2 * size_t{i}]);
}

/// A particle of a rigid fragment in a substep: on along its velocity; what it feels is added up for the
/// contact step of its fragment. `load`: N, N m.
template <class Real>
DEM_FN LoadedState<Real> carryOn(const SubstepArrays<Real>& arrays, const OwnParticle<Real>& own,
                                 const Wrench<Real>& load, const StepParams<Real>& params) {
    LoadedState<Real> next = own.state;
    const Vec3<Real> velocity = xyz(own.state.velocity) + carriedLed(arrays, params, own.id);
    Vec3<Real> low = lowPart(own.state.position, own.state.velocity, own.state.spin);
    addToPosition(params.carry_time * velocity.x, next.position.x, low.x);
    addToPosition(params.carry_time * velocity.y, next.position.y, low.y);
    addToPosition(params.carry_time * velocity.z, next.position.z, low.z);
    setLowPart(next, low);
    Vec4<Real>&force = arrays.carried[2 * size_t{own.id}], &torque = arrays.carried[2 * size_t{own.id} + 1];
    force = withW(xyz(force) + load.force, Real(0));
    torque = withW(xyz(torque) + load.torque, Real(0));
    return next;
}

/// W: what `part` of a load gives to the particle at a velocity on the way from that before the kick (share
/// 0) to that after it (1).
template <class Real>
DEM_FN Real powerAt(Real share, const Wrench<Real>& part, const LoadedState<Real>& before,
                    const LoadedState<Real>& after) {
    const Vec3<Real> kick = xyz(after.velocity) - xyz(before.velocity),
                     turn = xyz(after.spin) - xyz(before.spin);
    return dot(part.force, axpy(share, kick, xyz(before.velocity))) +
           dot(part.torque, axpy(share, turn, xyz(before.spin)));
}
/// W: the first half of a kick counts the velocity before it, the second half that after it. So what springs
/// take in and give back is their energy to the last joule, and all of a kick counts the mean velocity (B.1).
template <class Real>
DEM_FN Real meanPower(KickShare share, const Wrench<Real>& part, const LoadedState<Real>& before,
                      const LoadedState<Real>& after) {
    return powerAt(Real(share == KickShare::kAll ? 0.5 : 0), part, before, after);
}
/// s, of a substep's dt.
template <class Real>
DEM_FN Real timeOf(KickShare share, Real dt) {
    return Real(share == KickShare::kAll ? 1 : 0.5) * dt;
}

/// What is dissipated needs the velocities at which it acted. A bond that breaks pulls through this kick:
/// what its second half gives to the ends is taken off.
template <class Real>
DEM_FN void bookLedger(Vec4<Real>& ledger, const Tally<Real>& tally, const LoadedState<Real>& before,
                       const LoadedState<Real>& after, Real dt, KickShare share = KickShare::kAll) {
    const Real time = timeOf(share, dt), second_half = time - Real(0.5) * dt;
    bookedDamping(ledger) += madd(-time, meanPower(share, tally.damping, before, after), tally.contact_loss);
    bookedFriction(ledger) -=
        madd(time, meanPower(share, tally.friction, before, after), tally.spring_energy);
    bookedFracture(ledger) +=
        madd(-second_half, powerAt(Real(1), tally.released, before, after), tally.fracture);
}

/// A path changes the velocity of what it leads between two kicks, so that the first half of the next kick
/// acts at the former one. `now`: as the step finds it. `share`: of that half in the mean, where it is
/// shorter or longer than the other one.
template <class Real>
DEM_FN LoadedState<Real> beforeItWasLed(const SubstepArrays<Real>& arrays, uint32_t i,
                                        const LoadedState<Real>& now, Real share = Real(1)) {
    if (arrays.led_from.empty()) return now;
    const Vec3<Real> from = xyz(arrays.led_from[2 * size_t{i}]),
                     turned_from = xyz(arrays.led_from[2 * size_t{i} + 1]);
    LoadedState<Real> before = now;
    before.velocity = withLowOf(axpy(share, from, xyz(now.velocity)), now.velocity);
    before.spin = withLowOf(axpy(share, turned_from, xyz(now.spin)), now.spin);
    return before;
}
/// That kick is over; a dry step leaves what is remembered.
template <class Real>
DEM_FN void forgetHowItWasLed(const SubstepArrays<Real>& arrays, uint32_t i) {
    if (!arrays.led_from.empty())
        arrays.led_from[2 * size_t{i}] = arrays.led_from[2 * size_t{i} + 1] = Vec4<Real>{};
}

/// What holds a particle takes up the load, and gives the opposite of what that does.
template <class Real>
DEM_FN void bookHold(Vec4<Real>& ledger, const Wrench<Real>& load, const LoadedState<Real>& before,
                     const LoadedState<Real>& after, Real dt, KickShare share = KickShare::kAll) {
    bookedWork(ledger) = madd(-timeOf(share, dt), meanPower(share, load, before, after), bookedWork(ledger));
}

/// A carried particle: the velocity at the end of the contact step is not known yet, so that what damps and
/// rubs is added up for it too.
template <class Real>
DEM_FN void bookCarried(const SubstepArrays<Real>& arrays, uint32_t i, const Tally<Real>& tally) {
    const Vec3<Real> parts[4] = {tally.damping.force, tally.damping.torque, tally.friction.force,
                                 tally.friction.torque};
    for (uint32_t k = 0; k < 4; ++k) {
        Vec4<Real>& sum = arrays.carried_tally[4 * size_t{i} + k];
        sum = withW(xyz(sum) + parts[k], Real(0));
    }
    Vec4<Real>& ledger = arrays.ledger[i];
    bookedDamping(ledger) += tally.contact_loss;
    bookedFriction(ledger) -= tally.spring_energy;
}

/// The sums of bookCarried, cleared.
template <class Real>
DEM_FN Tally<Real> takeCarriedTally(const SubstepArrays<Real>& arrays, uint32_t i) {
    const auto take = [&](uint32_t k) {
        Vec4<Real>& sum = arrays.carried_tally[4 * size_t{i} + k];
        const Vec3<Real> taken = xyz(sum);
        sum = Vec4<Real>{};
        return taken;
    };
    Tally<Real> tally;
    tally.damping = {take(0), take(1)};
    tally.friction = {take(2), take(3)};
    return tally;
}

}  // namespace demolish
