// SPDX-License-Identifier: Apache-2.0
// What moves a particle in a substep once the loads of its bonds and contacts are summed: colliders, kick and
// drift, ledger. The same text on the CPU and in the first of the threads that share a particle on the GPU.
#pragma once
#include "sim_cuda/kernels/collider_contact.h"
#include "sim_cuda/kernels/integrate.h"

namespace demolish {

/// A dry substep leaves the fragment's velocity as it is.
template <bool kLedger, class Real>
DEM_FN void addColliders(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                         const OwnParticle<Real>& own, Wrench<Real>& load, Tally<Real>& tally) {
    const bool counts =
        arrays.fragments.known() && own.id < params.in_bodies && params.booked == KickShare::kAll;
    if (counts) arrays.fragments.fall(own.id, params.dt * params.gravity);
    forEachCollider(params, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
        const Wrench<Real> given =
            colliderContact<kLedger>(arrays, params, own, c, bound, tally, TurnsAlone<Real>{}).wrench;
        add(load, given);
        if (counts && length2(given.force) > Real(0)) arrays.fragments.push(own.id, params.dt * given.force);
    });
}

/// Writes the particle's state after the substep. `load`: of its slots, N, N m; `tally`: what they book.
template <bool kLedger, class Real>
DEM_FN void moveParticle(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                         const OwnParticle<Real>& own, Wrench<Real> load, Tally<Real>& tally) {
    const bool held = own.constants.isHeld();
    if (own.constants.isMovedHere() && !held) addColliders<kLedger>(arrays, params, own, load, tally);
    const LoadedState<Real> next =
        own.isCarried() ? carryOn(arrays, own, load, params) : kickAndDrift(own, load, params);
    if constexpr (kLedger) {
        if (own.isCarried())
            bookCarried(arrays, own.id, tally);
        else
            bookLedger(arrays.ledger[own.id], tally, own.state, next, params.dt, params.booked);
        if (held && !own.isCarried())
            bookHold(arrays.ledger[own.id], load, own.state, next, params.dt, params.booked);
    }
    storeState(arrays.out, own.id, next);
}

}  // namespace demolish
