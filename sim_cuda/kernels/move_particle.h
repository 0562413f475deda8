// SPDX-License-Identifier: Apache-2.0
// What moves a particle in a substep once the loads of its bonds and contacts are summed: colliders, kick and
// drift, ledger. The same text on the CPU and in the first of the threads that share a particle on the GPU.
#pragma once
#include "sim_cuda/kernels/collider_contact.h"
#include "sim_cuda/kernels/integrate.h"

namespace demolish {

/// Writes the particle's state after the substep. `load`: of its slots, N, N m; `tally`: what they book.
template <bool kLedger, class Real>
DEM_FN void moveParticle(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                         const OwnParticle<Real>& own, Wrench<Real> load, Tally<Real>& tally) {
    const bool held = own.constants.isHeld();
    if (own.constants.isMovedHere() && !held)
        forEachCollider(params, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
            add(load,
                colliderContact<kLedger>(arrays, params, own, c, bound, tally, TurnsAlone<Real>{}).wrench);
        });
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
