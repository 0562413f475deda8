// SPDX-License-Identifier: Apache-2.0
// What a frame's report needs of every particle, in one pass: ledger, broken bonds, highest stress.
#pragma once
#include "sim_cuda/data/ledger.h"
#include "sim_cuda/kernels/particle_value.h"

namespace demolish {

struct FrameSums {
    double damping = 0, friction = 0, fracture = 0;  ///< J since the ledger was cleared
    double held = 0;                                 ///< J, work of what holds particles, likewise
    double stress = 0;                               ///< highest bond stress over strength
    uint32_t broken = 0;                             ///< bonds, each counted at its lower id
    uint32_t parted = 0;                             ///< of these, those whose record has retired (A.6)

    DEM_FN void operator+=(const FrameSums& other) {
        damping += other.damping;
        friction += other.friction;
        fracture += other.fracture;
        held += other.held;
        stress = maxOf(stress, other.stress);
        broken += other.broken;
        parted += other.parted;
    }
};

/// kThreads threads a particle or projectile slot.
template <uint32_t kThreads, class Real>
struct SumFrame {
    SubstepArrays<Real> arrays;  ///< only read
    uint32_t in_bodies = 0;

    DEM_FN FrameSums operator()(uint32_t thread) const {
        const uint32_t i = thread / kThreads;
        const RowPart part{thread % kThreads, kThreads};
        FrameSums sums;
        if (part.number == 0) {
            Vec4<Real> ledger = arrays.ledger[i];
            sums = {static_cast<double>(bookedDamping(ledger)), static_cast<double>(bookedFriction(ledger)),
                    static_cast<double>(bookedFracture(ledger)), static_cast<double>(bookedWork(ledger))};
        }
        if (i >= in_bodies) return sums;
        sums.stress = static_cast<double>(worstStressRatio(arrays, loadOwn(arrays, i), i, part));
        for (uint32_t slot = arrays.bond_row[i] + part.number; slot < arrays.bond_row[i + 1]; slot += part.of)
            if (linkedParticle(arrays.link[slot]) > i && isBroken(arrays.link[slot])) {
                ++sums.broken;
                if (pairState(arrays.link[slot]) == PairState::kContact) ++sums.parted;
            }
        return sums;
    }
};

}  // namespace demolish
