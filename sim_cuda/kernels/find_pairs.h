// The search itself: what is found goes into short drafts, in any order; write_neighbours.h makes rows of
// them. There are few projectiles, and each may touch thousands, so that their rows are kept as one bit a
// particle: threads set bits in any order, and the bits are in the order of ids.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/find_neighbours.h"

namespace demolish {

/// Room for the first neighbours found of each particle; longer rows are searched again when they are
/// written.
struct RowDrafts {
    Span<uint32_t> count;      ///< per particle of a body: all found
    Span<uint32_t> neighbour;  ///< `length` a particle
    uint32_t length = 0;

    DEM_FN void put(uint32_t i, uint32_t place, uint32_t j) const {
        if (place < length) neighbour[size_t{i} * length + place] = j;
    }
};

inline constexpr uint32_t kBitsPerWord = 32;

/// The rows of all projectile slots: `words` words each.
struct ProjectileBits {
    Span<uint32_t> bits, count;  ///< of each word: particles that may meet the projectile; how many they are
    uint32_t words = 0;
};

DEM_FN void markProjectile(const ProjectileBits& rows, uint32_t slot, uint32_t i) {
    const uint32_t word = slot * rows.words + i / kBitsPerWord;
    atomicOrU32(&rows.bits[word], 1u << i % kBitsPerWord);
    atomicAddU32(&rows.count[word], 1);
}

/// One thread a member of the buckets, then one a projectile slot: the CPU. The GPU: find_pairs_cuda.cuh.
template <class Real>
struct FindPairs {
    NeighbourSearch<Real> search;
    RowDrafts drafts;
    ProjectileBits projectiles;

    DEM_FN void operator()(uint32_t at) const {
        if (at < search.in_bodies && at >= search.members()) return;
        const uint32_t i = at < search.in_bodies ? search.member.id[at] : at;
        uint32_t count = 0;
        const auto append = [&](uint32_t j) { drafts.put(i, count++, j); };
        if (at < search.in_bodies) search.visitNeighbours(search.member[at], append);
        const auto mark = [&](uint32_t p) {
            markProjectile(projectiles, p - search.in_bodies, i);
            if (at < search.in_bodies) append(p);
        };
        if (search.takesPart(i)) search.visitProjectiles(i, mark);
        if (at < search.in_bodies) drafts.count[i] = count;
    }
};

}  // namespace demolish
