// SPDX-License-Identifier: Apache-2.0
// What two particles, or a particle and a plane, set against their contact.
#pragma once
#include "sim_cuda/data/particles.h"
#include "sim_cuda/physics/touch_effect.h"

namespace demolish {

/// A particle whose inverse mass is negative stands for its share of a rigid fragment, which answers once in
/// kRigidStride substeps: a stiffness acts on it kRigidStride^2 times, a damper kRigidStride times as hard.
template <class Real>
DEM_FN PairInertia<Real> pairInertia(const ParticleConstants<Real>& i, const ParticleConstants<Real>& j) {
    if (!(i.inverse_mass < Real(0)) && !(j.inverse_mass < Real(0)))
        return {i.inverse_mass + j.inverse_mass, i.inverse_inertia + j.inverse_inertia};
    const bool i_slow = i.inverse_mass < Real(0);
    const ParticleConstants<Real>&slow = i_slow ? i : j, &fast = i_slow ? j : i;
    constexpr Real kStride = kRigidStride;
    const Real inverse = fast.inverse_mass - slow.inverse_mass;
    return {inverse, madd(kStride, slow.inverse_inertia, fast.inverse_inertia),
            inverse / (fast.inverse_mass - kStride * kStride * slow.inverse_mass),
            inverse / (fast.inverse_mass - kStride * slow.inverse_mass), true};
}

template <class Real>
DEM_FN PairInertia<Real> againstWall(const ParticleConstants<Real>& own) {
    return {own.inverse_mass, own.inverse_inertia};
}

}  // namespace demolish
