// Which slots of a rigid fragment's particles lead to other fragments: few of many, and the same from one
// decision to the next. So that contact steps on the GPU go through those alone.
#pragma once
#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {

/// Touches of each of the kPartials sums of an active particle that are kept; who has more goes through whole
/// rows.
inline constexpr uint32_t kMostTouches = 16, kTooManyTouches = kMostTouches + 1;

/// By place in RigidWork::active and sum: place * kPartials + sum.
struct RigidTouches {
    Span<uint32_t> slot;   ///< kMostTouches each: bond slot * 2, or contact slot * 2 + 1; bonds first
    Span<uint32_t> count;  ///< or kTooManyTouches
};

/// Valid until contact lists or fragments change. One thread a sum.
template <class Real>
struct ListTouches {
    SubstepArrays<Real> arrays;
    RigidWork work;
    RigidTouches touches;

    DEM_FN void operator()(uint32_t thread) const {
        const uint32_t place = thread / kPartials, sum = thread % kPartials;
        if (place >= work.counts[kActiveCount]) return;
        const uint32_t i = work.active[place], label = work.label[i];
        uint32_t* list = &touches.slot[size_t{thread} * kMostTouches];
        uint32_t count = 0;
        const auto add = [&](uint32_t entry) {
            if (count < kMostTouches) list[count] = entry;
            if (count < kTooManyTouches) ++count;
        };
        for (uint32_t slot = arrays.bond_row[i] + sum; slot < arrays.bond_row[i + 1]; slot += kPartials)
            if (joinsFragments(arrays.link[slot], work.label, label)) add(2 * slot);
        for (uint32_t slot = arrays.contact_row[i] + sum; slot < arrays.contact_row[i + 1]; slot += kPartials)
            if (work.label[arrays.neighbour[slot]] != label) add(2 * slot + 1);
        touches.count[thread] = count;
    }
};

}  // namespace demolish
