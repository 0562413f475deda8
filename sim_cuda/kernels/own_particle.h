// SPDX-License-Identifier: Apache-2.0
// A particle as its own thread holds it, and what it gathers: total load, and what the ledger books.
#pragma once
#include "sim_cuda/kernels/bond_pair.h"

namespace demolish {

template <class Real>
struct LoadedState {
    Vec4<Real> position, rotation, velocity, spin;
};

/// Where LoadedState has room for the low part of the position, m.
template <class Real>
DEM_FN void setLowPart(LoadedState<Real>& state, const Vec3<Real>& low) {
    state.position.w = low.x;
    state.velocity.w = low.y;
    state.spin.w = low.z;
}
template <class Real>
DEM_FN LoadedState<Real> loadState(const StateIn<Real>& in, uint32_t i) {
    return {in.position[i], in.rotation[i], in.velocity[i], in.spin[i]};
}
/// Without the orientation, which contacts do not need.
template <class Real>
DEM_FN LoadedState<Real> loadWithoutRotation(const StateIn<Real>& in, const Vec4<Real>& position,
                                             uint32_t i) {
    return {position, {}, in.velocity[i], in.spin[i]};
}

/// x_j - x_i from high and low parts.
template <class Real>
DEM_FN Vec3<Real> separation(const LoadedState<Real>& i, const LoadedState<Real>& j) {
    return (xyz(j.position) - xyz(i.position)) +
           (lowPart(j.position, j.velocity, j.spin) - lowPart(i.position, i.velocity, i.spin));
}

template <class Real>
DEM_FN PairMotion<Real> pairMotion(const LoadedState<Real>& i, const LoadedState<Real>& j) {
    return {separation(i, j), asQuat(i.rotation), asQuat(j.rotation), xyz(i.velocity),
            xyz(j.velocity),  xyz(i.spin),        xyz(j.spin)};
}

template <class Real>
struct OwnParticle {
    uint32_t id = 0;
    uint32_t owner = 0;
    LoadedState<Real> state;
    ParticleConstants<Real> constants;

    /// In a substep: of a rigid fragment (BondedWork).
    DEM_FN bool isCarried() const { return constants.isMovedByOther(); }
};

template <class Real>
DEM_FN OwnParticle<Real> loadOwn(const SubstepArrays<Real>& arrays, uint32_t i) {
    return {i, arrays.owner[i], loadState(arrays.in, i), arrays.constants[i]};
}

template <class Real>
DEM_FN void add(Wrench<Real>& sum, const Wrench<Real>& term) {
    sum.force = sum.force + term.force;
    sum.torque = sum.torque + term.torque;
}

/// Dissipation is booked with the mean velocity of the kick (physics B.1), which is known once all loads are
/// summed.
template <class Real>
struct Tally {
    Wrench<Real> damping, friction;  ///< parts of the total load
    Wrench<Real> released;           ///< likewise, of bonds that break in this substep
    Real spring_energy{};            ///< J, growth of tangential springs' energy (this particle's half of it)
    Real fracture{};                 ///< J, of those bonds, before the kick (at the lower id)
    Real contact_loss{};  ///< J, of contacts that grew softer, began or ended (this particle's half)

    DEM_FN void operator+=(const Tally& other) {
        add(damping, other.damping);
        add(friction, other.friction);
        add(released, other.released);
        spring_energy += other.spring_energy;
        fracture += other.fracture;
        contact_loss += other.contact_loss;
    }

    /// A bond breaks, of which this is one end.
    DEM_FN void addBreak(const BondRelease<Real>& release, bool is_lower_end) {
        add(released, release.load);
        if (is_lower_end) fracture += release.energy;
    }
};

}  // namespace demolish
