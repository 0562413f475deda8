// SPDX-License-Identifier: Apache-2.0
// What two particles, or a particle and a plane, set against their contact.
#pragma once
#include "sim_cuda/data/particles.h"
#include "sim_cuda/physics/touch_effect.h"

namespace demolish {

/// A particle that the other kind of step moves stands for its share of a rigid fragment, which answers once
/// in kRigidStride substeps: a stiffness acts on it kRigidStride^2 times, a damper kRigidStride times as
/// hard. At most one of the two is such a one.
template <class Real>
DEM_FN PairInertia<Real> pairInertia(const ParticleConstants<Real>& i, const ParticleConstants<Real>& j) {
    if (!i.isMovedByOther() && !j.isMovedByOther())
        return {i.inverseMass() + j.inverseMass(), i.inverse_inertia + j.inverse_inertia};
    const bool i_slow = i.isMovedByOther();
    const ParticleConstants<Real>&slow = i_slow ? i : j, &fast = i_slow ? j : i;
    constexpr Real kStride = kRigidStride;
    const Real light = fast.inverseMass(), heavy = slow.inverseMass(), inverse = light + heavy;
    return {inverse, madd(kStride, slow.inverse_inertia, fast.inverse_inertia),
            inverse / (light + kStride * kStride * heavy), inverse / (light + kStride * heavy), true};
}

/// Both are held by anchors, which lead them as they do whatever they feel. Faces of a bond between the two
/// that has broken still press until they part: they hold what the bond held.
template <class Real>
DEM_FN bool goThroughEachOther(const ParticleConstants<Real>& i, const ParticleConstants<Real>& j) {
    return i.isAnchored() && j.isAnchored();
}

template <class Real>
DEM_FN PairInertia<Real> againstWall(const ParticleConstants<Real>& own) {
    return {own.inverseMass(), own.inverse_inertia};
}

}  // namespace demolish
