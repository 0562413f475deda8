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

/// kThreads threads a particle: a part of its rows of cells each, or all of them (1). Projectile slots come
/// after the particles of bodies. Threads follow the order of the buckets, so that neighbouring ones read the
/// same members.
template <uint32_t kThreads, class Real>
struct FindPairs {
    static_assert(kThreads == 1 || kThreads % kCellRows == 0);
    NeighbourSearch<Real> search;
    RowDrafts drafts;
    ProjectileBits projectiles;

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t at = k / kThreads, part = k % kThreads;
        if (at >= search.in_bodies) return meetProjectiles(at, part, nullptr);
        if (at >= search.members()) return;
        const GridMember<Real> own = search.member[at];
        uint32_t count = 0;
        Append append{drafts, own.id, &count};
        if constexpr (kThreads == 1) {
            search.visitNeighbours(own, append);
        } else {
            constexpr uint32_t kStep = kThreads / kCellRows;
            search.visitRow(own, part / kStep, part % kStep, kStep, append);
        }
        meetProjectiles(own.id, part, &append);
        if constexpr (kThreads == 1) drafts.count[own.id] = count;
    }

  private:
    struct Append {
        RowDrafts drafts;
        uint32_t i;
        uint32_t* count;  ///< of the one thread
        DEM_FN void operator()(uint32_t j) {
            drafts.put(i, kThreads == 1 ? (*count)++ : atomicAddU32(&drafts.count[i], 1), j);
        }
    };
    struct MarkProjectile {
        ProjectileBits rows;
        uint32_t i, in_bodies;
        Append* row;  ///< null for a projectile, whose row is made of its bits
        DEM_FN void operator()(uint32_t p) {
            const uint32_t word = (p - in_bodies) * rows.words + i / kBitsPerWord;
            atomicOrU32(&rows.bits[word], 1u << i % kBitsPerWord);
            atomicAddU32(&rows.count[word], 1);
            if (row != nullptr) (*row)(p);
        }
    };
    DEM_FN void meetProjectiles(uint32_t i, uint32_t part, Append* row) const {
        if (!search.takesPart(i)) return;
        MarkProjectile mark{projectiles, i, search.in_bodies, row};
        search.visitProjectiles(i, part, kThreads, mark);
    }
};

}  // namespace demolish
