// SPDX-License-Identifier: Apache-2.0
// One substep on the CPU: solid bonds in lanes, then every particle sums its slots in the fixed order and
// moves.
#pragma once
#include "sim_cuda/kernels/bond_lanes.h"
#include "sim_cuda/kernels/move_particle.h"
#include "sim_cuda/kernels/partial_sums.h"
#include "sim_cuda/kernels/touch_slots.h"

namespace demolish {

template <bool kLedger, class Real>
class CpuParticleStep {
  public:
    CpuParticleStep(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                    const BondPairs<Real>& pairs)
        : arrays_(arrays), params_(params), pairs_(pairs) {}

    [[gnu::flatten]] void operator()(uint32_t i) const {
        const OwnParticle<Real> own = loadOwn(arrays_, i);
        Tally<Real> tally;
        Wrench<Real> load =
            i < params_.in_bodies ? sumRow<kPartials>(own, tally) : sumRow<kLongPartials>(own, tally);
        if (const auto& colliders = params_.colliders;
            isNearColliders<StepKind::kSubstep>(params_, colliders, own))
            add(load, collidersPush<kLedger>(arrays_, params_, colliders, own, tally));
        moveParticle<kLedger, Movable::kAll>(arrays_, params_, own, load, tally);
    }

  private:
    template <uint32_t kCount>
    Wrench<Real> sumRow(const OwnParticle<Real>& own, Tally<Real>& tally) const {
        PartialSums<kCount, Real> sums;
        const uint32_t first_bond = arrays_.bond_row[own.id], last_bond = arrays_.bond_row[own.id + 1];
        for (uint32_t slot = first_bond; slot < last_bond; ++slot)
            sums.add(slot - first_bond, bondSlot(own, slot, tally));
        const uint32_t first = arrays_.contact_row[own.id], last = arrays_.contact_row[own.id + 1];
        for (uint32_t slot = first; slot < last; ++slot)
            sums.add(slot - first,
                     contactSlot<kLedger>(arrays_, params_, own, slot, contactEnd(arrays_, slot), tally));
        return sums.total();
    }

    Wrench<Real> bondSlot(const OwnParticle<Real>& own, uint32_t slot, Tally<Real>& tally) const {
        const LinkEnd end = linkEnd(arrays_, slot);
        if (!isBonded(end.link)) return formerBondSlot<kLedger>(arrays_, params_, own, slot, end, tally);
        return own.isCarried() ? Wrench<Real>{} : recorded(own, slot, end, tally);
    }

    Wrench<Real> recorded(const OwnParticle<Real>& own, uint32_t slot, const LinkEnd& end,
                          Tally<Real>& tally) const {
        const BondRecord<Real>& record = pairs_.record[slot];
        if constexpr (kLedger) {
            const DampingRecord<Real>& damping = pairs_.damping[slot];
            add(tally.damping, {damping.force, damping.torque});
        }
        if (record.breaks > Real(0)) breakBond(own, slot, end, tally);
        return {record.force, record.torque};
    }

    void breakBond(const OwnParticle<Real>& own, uint32_t slot, const LinkEnd& end,
                   Tally<Real>& tally) const {
        arrays_.link[slot].link = linkWord(end.id, PairState::kBroken);
        if constexpr (kLedger) {
            const BondConstants<Real> bond =
                bondConstants(arrays_.rest[slot], end.link.grade, arrays_.body_laws[own.owner]);
            const PairMotion<Real> pair = pairMotion(own.state, loadState(arrays_.in, end.id));
            tally.addBreak(bondRelease(bond, pair), own.id < end.id);
        }
    }

    const SubstepArrays<Real>& arrays_;
    const StepParams<Real>& params_;
    const BondPairs<Real>& pairs_;
};

}  // namespace demolish
