// Pairs with projectiles. There are few projectiles, and each may touch thousands, so that their rows are
// kept as one bit a particle: threads set bits in any order, and the bits are in the order of ids.
#pragma once
#include "sim_cuda/backend/bit_count.h"
#include "sim_cuda/kernels/find_neighbours.h"

namespace demolish {

inline constexpr uint32_t kBitsPerWord = 32;

/// The rows of all projectile slots: `words` words each.
struct ProjectileBits {
    Span<uint32_t> bits, count;  ///< of each word: particles that may meet the projectile; how many they are
    uint32_t words = 0;
};

/// Thread i: particle i, of a body or a projectile itself, against all projectiles. Comes after
/// FindNeighbours.
template <class Real>
struct FindProjectiles {
    NeighbourSearch<Real> search;
    RowDrafts drafts;
    ProjectileBits rows;

    struct Append {
        RowDrafts drafts;
        ProjectileBits rows;
        uint32_t i, in_bodies;
        DEM_FN void operator()(uint32_t p) {
            const uint32_t word = (p - in_bodies) * rows.words + i / kBitsPerWord;
            atomicOrU32(&rows.bits[word], 1u << i % kBitsPerWord);
            atomicAddU32(&rows.count[word], 1);
            if (i < in_bodies) drafts.put(i, drafts.count[i]++, p);
        }
    };

    DEM_FN void operator()(uint32_t i) const {
        if (!search.takesPart(i)) return;
        Append append{drafts, rows, i, search.in_bodies};
        search.visitProjectiles(i, append);
    }
};

}  // namespace demolish
