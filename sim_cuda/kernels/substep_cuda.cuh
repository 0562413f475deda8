// SPDX-License-Identifier: Apache-2.0
// One substep on the GPU, one kernel: T threads gather a particle's slots, agree on the sum in the fixed
// order, and the first of them moves it. Whatever T is, slot k of a row ends in partial sum k mod kPartials
// and is added in slot order, so that every T, and the CPU, give the same bits (frame facts 3).
#pragma once
#include <utility>

#include "sim_cuda/backend/cuda_chained_launch.cuh"
#include "sim_cuda/kernels/move_particle.h"
#include "sim_cuda/kernels/partial_sums.h"
#include "sim_cuda/kernels/touch_slots.h"

namespace demolish {

inline constexpr uint32_t kSubstepBlock = 128;

/// Breaks it when its time has come.
template <bool kLedger, class Real>
__device__ __forceinline__ Wrench<Real> solidBondSlot(const SubstepArrays<Real>& arrays,
                                                      const StepParams<Real>& params,
                                                      const OwnParticle<Real>& own, const BodyLaw<Real>& law,
                                                      const FormerBond<Real>& read, Tally<Real>& tally) {
    const uint32_t j = linkedParticle(read.link);
    const BondConstants<Real> bond = bondConstants(read.rest, read.link.grade, law);
    const PairMotion<Real> pair = pairMotion(own.state, read.other);
    const BondEffect<Real> effect = bondEffect(bond, pair);
    const bool breaks = params.breaking != 0 && bondBreaks(effect.severity, effect.limit);
    if (breaks) arrays.link[read.slot].link = linkWord(j, PairState::kBroken);
    if constexpr (kLedger) {
        const BondEffect<Real> damping = bondDamping(bond, pair);
        add(tally.damping, {damping.force, damping.torque_i});
        if (breaks) tally.addBreak(bondRelease(bond, pair), own.id < j);
    }
    return {effect.force, effect.torque_i};
}

/// Many threads share a particle, so that there are few warps to hide the way to memory: reads ahead.
template <uint32_t T>
inline constexpr bool kReadsAhead = T >= 8;

/// A slot that is still a solid bond, which breaks when its time has come, or one that no longer is. Where
/// threads read ahead and some bonds of a warp are broken, what either kind needs is asked for before any of
/// it is used.
template <uint32_t T, bool kLedger, class Real>
__device__ __forceinline__ Wrench<Real> bondSlot(const SubstepArrays<Real>& arrays,
                                                 const StepParams<Real>& params, const OwnParticle<Real>& own,
                                                 const BodyLaw<Real>& law, uint32_t slot, const LinkEnd& end,
                                                 Tally<Real>& tally) {
    const uint32_t j = end.id;
    const BondLink link = end.link;
    const bool solid = isBonded(link);
    if (!kReadsAhead<T> && !solid) return formerBondSlot<kLedger>(arrays, params, own, slot, end, tally);
    FormerBond<Real> read{slot, link, loadState(arrays.in, j), {}, arrays.rest[slot], {}};
    if (kReadsAhead<T> && __any_sync(__activemask(), !solid)) {
        read.constants = arrays.constants[solid ? own.id : j];
        read.spring = arrays.bond_spring[solid ? 0 : slot];
        if (!solid)
            return isApart(own, read.other.position, read.constants, link, read.spring, params)
                       ? Wrench<Real>{}
                       : touchingFormerBond<kLedger>(arrays, params, own, read, tally);
    }
    return own.isCarried() ? Wrench<Real>{} : solidBondSlot<kLedger>(arrays, params, own, law, read, tally);
}

template <class Real>
__device__ __forceinline__ Wrench<Real> shuffledDown(const Wrench<Real>& value, uint32_t by, uint32_t width) {
    constexpr unsigned kAll = 0xffffffffu;
    return {
        {__shfl_down_sync(kAll, value.force.x, by, width), __shfl_down_sync(kAll, value.force.y, by, width),
         __shfl_down_sync(kAll, value.force.z, by, width)},
        {__shfl_down_sync(kAll, value.torque.x, by, width), __shfl_down_sync(kAll, value.torque.y, by, width),
         __shfl_down_sync(kAll, value.torque.z, by, width)}};
}

/// The partial sum that one of T threads keeps: of T = kPartials threads that with its own number; of more
/// the first kPartials keep one each and are handed the slots of the others.
template <uint32_t T, class Real>
class LanePartial {
    static_assert(T >= kPartials);

  public:
    /// Round r of a row: this thread's slot is r T + lane. All threads of the warp take part; an absent slot
    /// is null.
    __device__ __forceinline__ void add(const Wrench<Real>& term) {
        demolish::add(sum_, term);
        for (uint32_t from = kPartials; from < T; from += kPartials)
            demolish::add(sum_, shuffledDown(term, from, T));
    }
    /// In the row's first thread.
    __device__ __forceinline__ Wrench<Real> total() {
#pragma unroll
        for (uint32_t step = kPartials / 2; step > 0; step /= 2)
            demolish::add(sum_, shuffledDown(sum_, step, T));
        return sum_;
    }

  private:
    Wrench<Real> sum_;
};

/// Slots first .. last-1 of one list as one of T threads goes through them. peek(k) reads what the way to
/// memory is long for: where many threads share a particle there are few warps to hide it, and the next slot
/// is peeked at while one is computed. `peek_first(k)` does so for the first one.
template <uint32_t T, class Peek>
class RowCursor {
  public:
    template <class PeekFirst>
    __device__ __forceinline__ RowCursor(uint32_t first, uint32_t last, uint32_t lane, const Peek& peek,
                                         const PeekFirst& peek_first)
        : k_(first + lane), last_(last), peek_(peek) {
        if constexpr (kAhead)
            if (k_ < last_) ahead_ = peek_first(k_);
    }
    /// The same for the whole warp where sums are handed from thread to thread.
    __device__ __forceinline__ bool more() const {
        if constexpr (T > kPartials) return __any_sync(0xffffffffu, k_ < last_) != 0;
        return k_ < last_;
    }
    /// slot(k, peek(k)), or null beyond the end.
    template <class Slot>
    __device__ __forceinline__ auto next(const Slot& slot) {
        const uint32_t k = k_;
        const Seen seen = seenAt(k);
        k_ += T;
        if constexpr (kAhead)
            if (k_ < last_) ahead_ = peek_(k_);
        return k < last_ ? slot(k, seen) : decltype(slot(k, seen)){};
    }

  private:
    using Seen = decltype(std::declval<const Peek&>()(0u));
    static constexpr bool kAhead = kReadsAhead<T>;

    __device__ __forceinline__ Seen seenAt(uint32_t k) const {
        if constexpr (kAhead) return ahead_;
        return k < last_ ? peek_(k) : Seen{};
    }

    uint32_t k_;
    const uint32_t last_;
    const Peek& peek_;
    Seen ahead_{};
};

/// Adds all slots of a list, T at a time, to the right partial sums.
template <uint32_t T, class Real, class Peek, class Slot>
__device__ __forceinline__ void gatherRow(RowCursor<T, Peek>& row, LanePartial<T, Real>& sum,
                                          const Slot& slot) {
    while (row.more()) sum.add(row.next(slot));
}

/// Where the rows of a particle begin and end.
struct RowEnds {
    uint32_t first_bond = 0, last_bond = 0, first_contact = 0, last_contact = 0;
};
template <class Real>
__device__ __forceinline__ RowEnds rowEnds(const SubstepArrays<Real>& arrays, uint32_t i, bool present) {
    if (!present) return {};
    return {arrays.bond_row[i], arrays.bond_row[i + 1], arrays.contact_row[i], arrays.contact_row[i + 1]};
}

/// The other ends of the first slots that a thread goes through. No substep changes them, so that they are
/// read before its turn has come, and what they lead to is asked for all at once when it has.
struct FirstEnds {
    uint32_t bonded = 0, contact = 0, contact_owner = 0;
};
template <uint32_t T, class Real>
__device__ __forceinline__ FirstEnds firstEnds(const SubstepArrays<Real>& arrays, const RowEnds& ends,
                                               uint32_t lane) {
    FirstEnds first;
    if constexpr (kReadsAhead<T>) {
        const uint32_t bond = ends.first_bond + lane, contact = ends.first_contact + lane;
        // Past the first cache, which would keep a state of the pair that is changing meanwhile.
        if (bond < ends.last_bond) first.bonded = __ldcg(&arrays.link[bond].link) & kLinkIdMask;
        if (contact < ends.last_contact) {
            first.contact = arrays.neighbour[contact];
            first.contact_owner = arrays.owner[first.contact];
        }
    }
    return first;
}

/// The rows of a particle. Both start before the first is gone through.
template <uint32_t T, class Real, class BondSlot, class ContactSlot>
__device__ __forceinline__ void gatherRows(const SubstepArrays<Real>& arrays, const RowEnds& ends,
                                           const FirstEnds& first_ends, uint32_t lane,
                                           LanePartial<T, Real>& sum, const BondSlot& bond_slot,
                                           const ContactSlot& contact_slot) {
    const auto link_end = [&](uint32_t slot) { return linkEnd(arrays, slot); };
    const auto contact_end = [&](uint32_t slot) {
        return kReadsAhead<T> ? contactEndWithOwner(arrays, slot) : contactEnd(arrays, slot);
    };
    RowCursor<T, decltype(link_end)> bonds(ends.first_bond, ends.last_bond, lane, link_end,
                                           [&](uint32_t slot) {
                                               return LinkEnd{first_ends.bonded, arrays.link[slot]};
                                           });
    RowCursor<T, decltype(contact_end)> contacts(
        ends.first_contact, ends.last_contact, lane, contact_end, [&](uint32_t) {
            const uint32_t j = first_ends.contact;
            return ContactEnd<Real>{j, first_ends.contact_owner, arrays.in.position[j], arrays.constants[j]};
        });
    gatherRow<T>(bonds, sum, bond_slot);
    gatherRow<T>(contacts, sum, contact_slot);
}

/// In the row's first thread; the ledger is no part of the state, so that its order may depend on T.
template <uint32_t T, class Real>
__device__ __forceinline__ void sumTally(Tally<Real>& tally) {
#pragma unroll
    for (uint32_t step = T / 2; step > 0; step /= 2) {
        add(tally.damping, shuffledDown(tally.damping, step, T));
        add(tally.friction, shuffledDown(tally.friction, step, T));
        add(tally.released, shuffledDown(tally.released, step, T));
        tally.spring_energy += __shfl_down_sync(0xffffffffu, tally.spring_energy, step, T);
        tally.fracture += __shfl_down_sync(0xffffffffu, tally.fracture, step, T);
        tally.contact_loss += __shfl_down_sync(0xffffffffu, tally.contact_loss, step, T);
    }
}

/// A projectile: its row is long, so that a whole block gathers it into kLongPartials sums.
template <bool kLedger, class Real>
__device__ void stepProjectile(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                               uint32_t i) {
    static_assert(kSubstepBlock == kLongPartials);
    __shared__ alignas(16) unsigned char sums_memory[kLongPartials * sizeof(Wrench<Real>)];
    __shared__ alignas(16) unsigned char tallies_memory[kLedger ? kLongPartials * sizeof(Tally<Real>) : 16];
    auto* sums = reinterpret_cast<Wrench<Real>*>(sums_memory);
    auto* tallies = reinterpret_cast<Tally<Real>*>(tallies_memory);
    const OwnParticle<Real> own = loadOwn(arrays, i);
    const uint32_t lane = threadIdx.x;
    Wrench<Real> sum;
    Tally<Real> tally;
    const uint32_t first = arrays.contact_row[i], last = arrays.contact_row[i + 1];
    constexpr uint32_t kBatch = 4, kStep = kBatch * kLongPartials;
    for (uint32_t base = first + lane; base < last; base += kStep) {
        ContactEnd<Real> ends[kBatch];  // read together: of a long row hardly any touches
#pragma unroll
        for (uint32_t b = 0; b < kBatch; ++b)
            if (base + b * kLongPartials < last) ends[b] = contactEnd(arrays, base + b * kLongPartials);
#pragma unroll
        for (uint32_t b = 0; b < kBatch; ++b)
            if (base + b * kLongPartials < last)
                add(sum, contactSlot<kLedger>(arrays, params, own, base + b * kLongPartials, ends[b], tally));
    }
    sums[lane] = sum;
    if constexpr (kLedger) tallies[lane] = tally;
    for (uint32_t step = kLongPartials / 2; step > 0; step /= 2) {
        __syncthreads();
        if (lane >= step) continue;
        add(sums[lane], sums[lane + step]);
        if constexpr (kLedger) tallies[lane] += tallies[lane + step];
    }
    if (lane == 0) moveParticle<kLedger>(arrays, params, own, sums[0], kLedger ? tallies[0] : tally);
}

/// Blocks that a multiprocessor shall hold: where many threads share a particle there are few particles, and
/// registers are worth more than blocks.
constexpr int blocksAtOnce(uint32_t threads) {
    return threads >= 16 ? 4 : threads >= 8 ? 5 : 6;
}

/// Places of the work list.
template <class Real>
__device__ __forceinline__ uint32_t workCount(const SubstepArrays<Real>& arrays,
                                              const StepParams<Real>& params) {
    return arrays.work.all() ? params.in_bodies : arrays.work.listed();
}
/// The particle at a place; beyond the list an old one, so that it is read together with the list's length.
template <class Real>
__device__ __forceinline__ uint32_t workAt(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                           uint32_t k) {
    const uint32_t last = params.in_bodies - 1, place = k < last ? k : last;
    return arrays.work.all() ? place : arrays.work.ids[place];
}

/// The first kMaxProjectiles blocks do one projectile each, since their rows are the longest, the others the
/// bodies' particles: all, or those of the work list. Started while the substep before still runs:
/// what no substep changes is read before its end is waited for.
template <uint32_t T, bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock, kLedger ? 4 : blocksAtOnce(T))
    substepKernel(const SubstepArrays<Real> arrays, const StepParams<Real> params) {
    const uint32_t block = blockIdx.x;
    letNextStart();
    constexpr uint32_t kParticles = kSubstepBlock / T;
    if (block < kMaxProjectiles) {
        awaitPrevious();
        const uint32_t shot = params.in_bodies + block;
        if (arrays.work.movesProjectile(shot)) stepProjectile<kLedger>(arrays, params, shot);
        return;
    }
    const uint32_t first = (block - kMaxProjectiles) * kParticles;
    const uint32_t k = first + threadIdx.x / T, lane = threadIdx.x % T;
    const uint32_t id = workAt(arrays, params, k), count = workCount(arrays, params);
    if (first >= count) return;
    const bool present = k < count;
    const RowEnds ends = rowEnds(arrays, id, present);
    const BodyLaw<Real> law = arrays.body_laws[arrays.owner[id]];
    const FirstEnds first_ends = firstEnds<T>(arrays, ends, lane);
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    LanePartial<T, Real> sum;
    Tally<Real> tally;
    gatherRows<T>(
        arrays, ends, first_ends, lane, sum,
        [&](uint32_t slot, const LinkEnd& end) {
            return bondSlot<T, kLedger>(arrays, params, own, law, slot, end, tally);
        },
        [&](uint32_t slot, const ContactEnd<Real>& end) {
            return contactSlot<kLedger>(arrays, params, own, slot, end, tally);
        });
    __syncwarp();
    const Wrench<Real> load = sum.total();
    if constexpr (kLedger) sumTally<T>(tally);
    if (!present || lane != 0) return;
    moveParticle<kLedger>(arrays, params, own, load, tally);
}

}  // namespace demolish
