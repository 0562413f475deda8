// SPDX-License-Identifier: Apache-2.0
// Clustering (paper 3.2.1) as connected components over intact bonds: every particle ends with the lowest id
// of its fragment. Trees hang from lower ids to higher ones and only roots are joined, so that the outcome
// does not depend on which thread comes first.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/bonds.h"

namespace demolish {

/// Do both ends belong together? Without owners of particles all do that are bonded.
DEM_FN bool isOfOneBody(const Span<const uint32_t>& owner, uint32_t i, uint32_t j) {
    return owner.empty() || owner[i] == owner[j];
}

/// The lowest of a particle and the particles bonded to it: most of a fragment hangs together before anything
/// is joined.
struct StartLabels {
    Span<const uint32_t> bond_row;
    Span<const BondLink> link;
    Span<uint32_t> label;
    uint32_t in_bodies = 0;
    Span<const uint32_t> owner{};  ///< as isOfOneBody

    DEM_FN void operator()(uint32_t i) const {
        uint32_t lowest = i;
        if (i < in_bodies)
            for (uint32_t slot = bond_row[i]; slot < bond_row[i + 1]; ++slot) {
                const uint32_t j = linkedParticle(link[slot]);
                if (j < lowest && isBonded(link[slot]) && isOfOneBody(owner, i, j)) lowest = j;
            }
        label[i] = lowest;
    }
};

/// Follows labels to the one that names itself.
DEM_FN uint32_t rootOf(const Span<uint32_t>& label, uint32_t i) {
    for (uint32_t next = atomicLoadU32(&label[i]); next != i; next = atomicLoadU32(&label[i])) i = next;
    return i;
}

/// Hangs the higher root under the lower one; whatever another thread had hung there meanwhile is joined too.
/// Most pairs hang under the same one already, which two reads at the same time tell.
DEM_FN void join(const Span<uint32_t>& label, uint32_t a, uint32_t b) {
    const uint32_t above_a = atomicLoadU32(&label[a]), above_b = atomicLoadU32(&label[b]);
    if (above_a == above_b) return;
    a = rootOf(label, above_a);
    b = rootOf(label, above_b);
    while (a != b) {
        const uint32_t high = a < b ? b : a, low = a < b ? a : b;
        const uint32_t before = atomicMinU32(&label[high], low);
        if (before == high) return;
        a = rootOf(label, before);
        b = rootOf(label, low);
    }
}

/// kThreads threads a particle; each bond once, from its lower end.
template <uint32_t kThreads>
struct JoinBonded {
    Span<const uint32_t> bond_row;
    Span<const BondLink> link;
    Span<uint32_t> label;
    Span<const uint32_t> owner{};  ///< as isOfOneBody

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = k / kThreads;
        for (uint32_t slot = bond_row[i] + k % kThreads; slot < bond_row[i + 1]; slot += kThreads) {
            const uint32_t j = linkedParticle(link[slot]);
            if (j > i && isBonded(link[slot]) && isOfOneBody(owner, i, j)) join(label, i, j);
        }
    }
};

struct FlattenLabels {
    Span<uint32_t> label;
    DEM_FN void operator()(uint32_t i) const { atomicMinU32(&label[i], rootOf(label, i)); }
};

}  // namespace demolish
