// SPDX-License-Identifier: Apache-2.0
// Solid bonds on the CPU, several at once: each bond is evaluated once, in lanes that the compiler turns into
// vector instructions, and its effect on both ends is left in their slots for the particles to sum. The
// numbers are those that each end would compute by itself, since the laws are odd in i and j to the last bit.
#pragma once
#include "sim_cuda/kernels/own_particle.h"

namespace demolish {

/// What a bond does to the particle of one slot.
template <class Real>
struct alignas(8 * sizeof(Real)) BondRecord {
    Vec3<Real> force, torque;
    Real breaks{};  ///< 1: the bond is gone after this substep
};
/// The damper's part of it, for the ledger.
template <class Real>
struct alignas(8 * sizeof(Real)) DampingRecord {
    Vec3<Real> force, torque;
};

/// Views of the bonds as pairs (CPU only).
template <class Real>
struct BondPairs {
    Span<const uint32_t> slot_of_bond, twin;
    Span<BondRecord<Real>> record;      ///< per slot
    Span<DampingRecord<Real>> damping;  ///< per slot; empty without the ledger
};

inline constexpr size_t kLanes = 16;

template <class Real>
using Lane = Real[kLanes];
template <class Real>
struct alignas(64) LaneVector {
    Lane<Real> x, y, z;

    void set(size_t l, const Vec3<Real>& a) {
        x[l] = a.x;
        y[l] = a.y;
        z[l] = a.z;
    }
    Vec3<Real> at(size_t l) const { return {x[l], y[l], z[l]}; }
};
template <class Real>
struct alignas(64) LaneQuat {
    Lane<Real> x, y, z, w;

    void set(size_t l, const Vec4<Real>& a) {
        x[l] = a.x;
        y[l] = a.y;
        z[l] = a.z;
        w[l] = a.w;
    }
    Quat<Real> at(size_t l) const { return {x[l], y[l], z[l], w[l]}; }
};

template <class Real>
struct BondLanesIn {
    LaneVector<Real> separation, velocity_i, velocity_j, spin_i, spin_j, rest;
    LaneQuat<Real> rotation_i, rotation_j;
    Lane<Real> stiffness, radius, strength, shear_ratio, beta_r;

    PairMotion<Real> pair(size_t l) const {
        return {separation.at(l), rotation_i.at(l), rotation_j.at(l), velocity_i.at(l),
                velocity_j.at(l), spin_i.at(l),     spin_j.at(l)};
    }
    BondConstants<Real> bond(size_t l) const {
        return {rest.at(l), roundBond(stiffness[l], shear_ratio[l], radius[l]), radius[l], strength[l],
                beta_r[l]};
    }
};
template <class Real>
struct BondLanesOut {
    LaneVector<Real> force, torque_i, torque_j;
    Lane<Real> severity, limit;
};
template <class Real>
struct DampingLanesOut {
    LaneVector<Real> force, torque_i, torque_j;
};

template <class Real>
[[gnu::flatten]] inline void computeLanes(const BondLanesIn<Real>& in, BondLanesOut<Real>& out) {
#pragma GCC ivdep
    for (size_t l = 0; l < kLanes; ++l) {
        const BondEffect<Real> effect = bondEffect(in.bond(l), in.pair(l));
        out.force.set(l, effect.force);
        out.torque_i.set(l, effect.torque_i);
        out.torque_j.set(l, effect.torque_j);
        out.severity[l] = effect.severity;
        out.limit[l] = effect.limit;
    }
}
template <class Real>
[[gnu::flatten]] inline void computeDamping(const BondLanesIn<Real>& in, DampingLanesOut<Real>& out) {
#pragma GCC ivdep
    for (size_t l = 0; l < kLanes; ++l) {
        const BondEffect<Real> effect = bondDamping(in.bond(l), in.pair(l));
        out.force.set(l, effect.force);
        out.torque_i.set(l, effect.torque_i);
        out.torque_j.set(l, effect.torque_j);
    }
}

/// Evaluates the solid ones among bonds first .. last-1.
template <bool kLedger, class Real>
class BondLanes {
  public:
    BondLanes(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, const BondPairs<Real>& pairs)
        : arrays_(arrays), params_(params), pairs_(pairs) {}

    /// Bonds first .. last-1 of the work list, or of all.
    void evaluate(size_t first, size_t last) {
        size_t lanes = 0;
        const BondedWork& work = arrays_.work;
        for (size_t k = first; k < last; ++k) {
            const uint32_t slot = pairs_.slot_of_bond[work.all() ? k : work.bonds[k]];
            if (!isBonded(arrays_.link[slot])) continue;
            load(lanes, slot);
            if (++lanes == kLanes) flush(lanes);
        }
        if (lanes > 0) {
            for (size_t l = lanes; l < kLanes; ++l) load(l, slot_[0]);
            flush(lanes);
        }
    }

  private:
    void load(size_t l, uint32_t slot) {
        const uint32_t twin = pairs_.twin[slot];
        const BondLink link = arrays_.link[slot];
        const uint32_t i = linkedParticle(arrays_.link[twin]), j = linkedParticle(link);
        const LoadedState<Real> a = loadState(arrays_.in, i), b = loadState(arrays_.in, j);
        const BodyLaw<Real>& law = arrays_.body_laws[arrays_.owner[i]];
        const Vec4<Real> rest = arrays_.rest[slot];
        slot_[l] = slot;
        in_.separation.set(l, separation(a, b));
        in_.rotation_i.set(l, a.rotation);
        in_.rotation_j.set(l, b.rotation);
        in_.velocity_i.set(l, xyz(a.velocity));
        in_.velocity_j.set(l, xyz(b.velocity));
        in_.spin_i.set(l, xyz(a.spin));
        in_.spin_j.set(l, xyz(b.spin));
        in_.rest.set(l, xyz(rest));
        in_.stiffness[l] = normalStiffnessOf(rest);
        in_.radius[l] = gradedRadius(link.grade, law);
        in_.strength[l] = gradedStrength(link.grade, law);
        in_.shear_ratio[l] = law.shear_ratio;
        in_.beta_r[l] = law.beta_r;
    }

    void flush(size_t& lanes) {
        computeLanes(in_, out_);
        if constexpr (kLedger) computeDamping(in_, damping_);
        for (size_t l = 0; l < lanes; ++l) store(l);
        lanes = 0;
    }

    void store(size_t l) {
        const uint32_t slot = slot_[l], twin = pairs_.twin[slot];
        const Real breaks =
            params_.breaking != 0 && bondBreaks(out_.severity[l], out_.limit[l]) ? Real(1) : Real(0);
        pairs_.record[slot] = {out_.force.at(l), out_.torque_i.at(l), breaks};
        pairs_.record[twin] = {-out_.force.at(l), -out_.torque_j.at(l), breaks};
        if constexpr (kLedger) {
            pairs_.damping[slot] = {damping_.force.at(l), damping_.torque_i.at(l)};
            pairs_.damping[twin] = {-damping_.force.at(l), -damping_.torque_j.at(l)};
        }
    }

    const SubstepArrays<Real>& arrays_;
    const StepParams<Real>& params_;
    const BondPairs<Real>& pairs_;
    uint32_t slot_[kLanes] = {};
    BondLanesIn<Real> in_;
    BondLanesOut<Real> out_;
    DampingLanesOut<Real> damping_;
};

}  // namespace demolish
