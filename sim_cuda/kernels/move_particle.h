// SPDX-License-Identifier: Apache-2.0
// What moves a particle in a substep: what colliders give it, then kick and drift with that and the loads of
// its bonds and contacts, and the ledger. The same text on the CPU and on the GPU.
#pragma once
#include "sim_cuda/kernels/collider_contact.h"
#include "sim_cuda/kernels/integrate.h"

namespace demolish {

/// N, N m, of all colliders that it isNearColliders() of; its own state alone says it.
template <bool kLedger, class Real, class Colliders, class Source = LooksItself<>>
DEM_FN Wrench<Real> collidersPush(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                  const Colliders& colliders, const OwnParticle<Real>& own,
                                  Tally<Real>& tally, const Source& source = {}) {
    Wrench<Real> load;
    const TurnsAlone<Real, Source> alone{cornersOf(arrays.corners, own.id), source};
    forEachCollider(colliders, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
        add(load, colliderContact<kLedger>(arrays, params, colliders, own, c, bound, tally, alone).wrench);
    });
    return load;
}

/// Writes the particle's state after the substep. `load`: of its slots and of colliders, N, N m; `tally`:
/// what they book.
template <bool kLedger, Movable kMovable, class Real>
DEM_FN void moveParticle(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                         const OwnParticle<Real>& own, const Wrench<Real>& load, const Tally<Real>& tally) {
    const LoadedState<Real> next =
        own.isCarried() ? carryOn(arrays, own, load, params) : kickAndDrift<kMovable>(own, load, params);
    if constexpr (kLedger) {
        Vec4<Real>& ledger = arrays.ledger[own.id];
        if (own.isCarried()) {
            bookCarried(arrays, own.id, tally);
        } else if (own.constants.isHeld()) {
            const LoadedState<Real> before = beforeItWasLed(arrays, own.id, own.state);
            bookLedger(ledger, tally, before, next, params.dt, params.booked);
            bookHold(ledger, load, before, next, params.dt, params.booked);
            if (params.booked == KickShare::kAll) forgetHowItWasLed(arrays, own.id);
        } else {
            bookLedger(ledger, tally, own.state, next, params.dt, params.booked);
        }
    }
    storeState(arrays.out, own.id, next);
}

}  // namespace demolish
