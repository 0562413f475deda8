// SPDX-License-Identifier: Apache-2.0
// The search itself: what is found goes into short drafts, in any order; write_neighbours.h makes rows of
// them. There are few projectiles, and each may touch thousands, so that their rows are kept as one bit a
// particle: threads set bits in any order, and the bits are in the order of ids.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/find_neighbours.h"

namespace demolish {

/// Room for the first neighbours found of each particle, and more for those set apart, whose rows are long;
/// rows that are longer still are searched again when they are written.
struct RowDrafts {
    Span<uint32_t> count;                   ///< per particle of a body, 0 before: all found
    Span<uint32_t> neighbour, long_drafts;  ///< `length` a particle; `long_length` for each set apart
    uint32_t length = 0, long_length = 0;

    DEM_FN void put(uint32_t i, uint32_t place, uint32_t j) const {
        if (place < length) neighbour[size_t{i} * length + place] = j;
    }
    /// Particle i is number `apart` of those set apart; any thread may call this.
    DEM_FN void putApart(uint32_t i, uint32_t apart, uint32_t j) const {
        const uint32_t place = atomicAddU32(&count[i], 1);
        if (place < long_length) long_drafts[size_t{apart} * long_length + place] = j;
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

/// One thread a member, then one a projectile slot: the CPU. The GPU: find_pairs_cuda.cuh. A pair of which
/// one is set apart goes into both rows when the other finds it.
template <class Real>
struct FindPairs {
    NeighbourSearch<Real> search;
    RowDrafts drafts;
    ProjectileBits projectiles;

    DEM_FN void operator()(uint32_t at) const {
        if (at >= search.in_bodies) return meetProjectiles(at, [](uint32_t) {});
        if (at >= search.allMembers()) return;
        at < search.members() ? inGrid(search.member[at]) : apart(search.member[at], at - search.members());
    }

  private:
    DEM_FN void inGrid(const GridMember<Real>& own) const {
        uint32_t count = 0;
        const auto append = [&](uint32_t j) { drafts.put(own.id, count++, j); };
        const auto appendMember = [&](uint32_t at) { append(search.member.id[at]); };
        const auto appendBoth = [&](uint32_t at) {
            appendMember(at);
            drafts.putApart(search.member.id[at], at - search.members(), own.id);
        };
        search.visitGrid(own, appendMember);
        search.visitApart(own, appendBoth);
        meetProjectiles(own.id, append);
        drafts.count[own.id] = count;
    }
    DEM_FN void apart(const GridMember<Real>& own, uint32_t number) const {
        const auto append = [&](uint32_t j) { drafts.putApart(own.id, number, j); };
        const auto appendMember = [&](uint32_t at) { append(search.member.id[at]); };
        search.visitApart(own, appendMember);
        meetProjectiles(own.id, append);
    }
    template <class Append>
    DEM_FN void meetProjectiles(uint32_t i, const Append& append) const {
        if (!search.takesPart(i)) return;
        const auto mark = [&](uint32_t p) {
            markProjectile(projectiles, p - search.in_bodies, i);
            append(p);
        };
        search.visitProjectiles(i, mark);
    }
};

}  // namespace demolish
