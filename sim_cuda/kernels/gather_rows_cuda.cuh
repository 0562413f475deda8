// SPDX-License-Identifier: Apache-2.0
// How T threads go through the rows of a particle on the GPU: slots of its bonds and contacts, each read
// ahead of its turn where few warps hide the way to memory, and their sum in the fixed order (frame facts 3).
#pragma once
#include <utility>

#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/kernels/partial_sums.h"
#include "sim_cuda/kernels/touch_slots.h"

namespace demolish {

/// Many threads share a particle, so that there are few warps to hide the way to memory: reads ahead.
template <uint32_t T>
inline constexpr bool kReadsAhead = T >= 8;

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
        ends.first_contact, ends.last_contact, lane, contact_end, [&](uint32_t slot) {
            return contactEndOf(arrays, slot, first_ends.contact, first_ends.contact_owner);
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

}  // namespace demolish
