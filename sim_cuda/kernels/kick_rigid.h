// SPDX-License-Identifier: Apache-2.0
// For a measurement: what the contact step to come would give to the particles of rigid fragments, and what
// the first half of that dissipates. Nothing moves.
#pragma once
#include "sim_cuda/kernels/integrate.h"
#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {

/// One thread a place of RigidWork::active, whose loads have been gathered, after a dry substep where some
/// are carried. In place of what has been added up for carried particles it leaves by how much a kick of
/// `time` s would change the particle's velocity and spin if it were alone: times its own mass and velocity
/// that is what the load gives to the fragment there.
template <class Real>
struct KickRigid {
    SubstepArrays<Real> arrays;  ///< at the moment that is measured
    RigidWork work;
    Span<const RigidLoadsOf<Real>> loads;  ///< by place
    Span<const ParticleConstants<Real>> own_constants;
    Real time{};  ///< s, from as long before the moment as after it
    uint32_t carries = 0, ledger = 0;

    DEM_FN void operator()(uint32_t place) const {
        if (place >= work.counts[kActiveCount]) return;
        const uint32_t i = work.active[place];
        const ParticleConstants<Real> own = own_constants[i];
        Wrench<Real> load = loads[place].push().wrench;
        Vec4<Real>&kick = arrays.carried[2 * size_t{i}], &turn = arrays.carried[2 * size_t{i} + 1];
        if (carries != 0) add(load, Wrench<Real>{xyz(kick), xyz(turn)});
        if (!own.isHeld()) {
            kick = withW((time * own.inverseMass()) * load.force, Real(0));
            turn = withW((time * own.inverse_inertia) * load.torque, Real(0));
        }
        if (ledger == 0) return;
        LoadedState<Real> now = loadState(arrays.in, i);
        if (own.isHeld()) {
            now = beforeItWasLed(arrays, i, now);
            bookHold(arrays.ledger[i], load, now, now, time, KickShare::kFirstHalf);
        }
        bookLedger(arrays.ledger[i], loads[place].tally(), now, now, time, KickShare::kFirstHalf);
        if (carries != 0)
            bookLedger(arrays.ledger[i], takeCarriedTally(arrays, i), now, now, time, KickShare::kFirstHalf);
    }
};

}  // namespace demolish
