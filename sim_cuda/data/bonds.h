// SPDX-License-Identifier: Apache-2.0
// Bonds as rows: every particle has one slot for each of its bonds, in the order of the other particle's id,
// and each bond therefore two slots, one at each end. The record of a bond owns its pair for ever: bonded,
// broken, at last plain contact; such a pair never appears in the contact list as well. Cells of two bodies
// that lie against each other at the start have such records too, which were never bonds and have no number.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/sorted_row.h"
#include "sim_cuda/data/vec4.h"
#include "sim_cuda/physics/pair_state.h"

namespace demolish {

/// The other end and the state of the pair in one word (up to 2^30 particles), and the bond's grade.
struct alignas(8) BondLink {
    uint32_t link = 0;   ///< id of the other particle | PairState << 30
    uint32_t grade = 0;  ///< 2 x unorm16: low half radius a_b, high half strength factor, as shares of the
                         ///< body's largest; 0 of a record that was never a bond
};

inline constexpr uint32_t kLinkIdMask = 0x3fffffffu;

DEM_FN uint32_t linkedParticle(const BondLink& link) {
    return link.link & kLinkIdMask;
}
DEM_FN PairState pairState(const BondLink& link) {
    return static_cast<PairState>(link.link >> 30);
}
DEM_FN bool isBonded(const BondLink& link) {
    return pairState(link) == PairState::kBonded;
}
DEM_FN bool isBroken(const BondLink& link) {
    return !isBonded(link) && link.grade != 0;
}
/// A broken bond, or cells of two bodies that have been against each other since the start: they touch where
/// their record says, which may be before their spheres do.
DEM_FN bool hasFaces(const BondLink& link) {
    return pairState(link) == PairState::kBroken || pairState(link) == PairState::kFacing;
}
DEM_FN uint32_t linkWord(uint32_t particle, PairState state) {
    return particle | static_cast<uint32_t>(state) << 30;
}
DEM_FN uint32_t gradeRadius(uint32_t grade) {
    return grade & 0xffffu;
}
DEM_FN uint32_t gradeStrength(uint32_t grade) {
    return grade >> 16;
}

/// Slots of particle i: row_start[i] .. row_start[i + 1] - 1 (projectiles have none).
template <class Real>
struct BondRowsIn {
    Span<const uint32_t> row_start;  ///< total + 1
    Span<const BondLink> link;       ///< per slot
    Span<const Vec4<Real>> rest;     ///< per slot: (x_j - x_i at rest, m; normalStiffnessOf); kFacing: in the
                                     ///< world, 0
    Span<const Vec4<Real>> spring;   ///< per slot, once broken: kept_spring.h
    uint32_t facing = 0;             ///< slots that began as kFacing
};
/// N/m, k_N, of what a slot knows of the bond at rest.
template <class Real>
DEM_FN Real normalStiffnessOf(const Vec4<Real>& rest) {
    return rest.w;
}

/// The slot of the bond from i to j, in whatever state it is; row_start[i + 1] when there is none.
DEM_FN uint32_t findBond(const Span<const uint32_t>& row_start, const Span<const BondLink>& link, uint32_t i,
                         uint32_t j) {
    return slotOfId(row_start[i], row_start[i + 1], j,
                    [&](uint32_t slot) { return linkedParticle(link[slot]); });
}

/// Particles that their bonds leave no outside: while all of them hold, nothing but a projectile touches such
/// a particle.
struct Enclosures {
    Span<const uint32_t> buried;     ///< per particle of a body: 1 of such a particle
    Span<const uint32_t> row_start;  ///< as BondRowsIn has them
    Span<const BondLink> link;
    uint32_t in_bodies = 0;

    /// Of a particle or projectile slot.
    DEM_FN bool hold(uint32_t i) const { return i < in_bodies && buried[i] != 0 && allBondsHold(i); }
    /// And so do the bonds of all that it is bonded to: no crack reaches it for a while. `uncracked`: of each
    /// particle, whether allBondsHold().
    DEM_FN bool holdDeeply(uint32_t i, const Span<const uint8_t>& uncracked) const {
        if (buried[i] == 0 || uncracked[i] == 0) return false;
        bool all_hold = true;
        for (uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot)
            all_hold = uncracked[linkedParticle(link[slot])] != 0 && all_hold;
        return all_hold;
    }
    /// Of a particle of a body.
    DEM_FN bool allBondsHold(uint32_t i) const {
        bool all_hold = true;  // no early end: reads need not wait for each other
        for (uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot)
            all_hold = !isBroken(link[slot]) && all_hold;
        return all_hold;
    }
};

template <class Backend, class Real>
struct BondArrays {
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    uint32_t count = 0;   ///< bonds: half the slots, but for those that were never bonds
    uint32_t facing = 0;  ///< as BondRowsIn
    Buffer<uint32_t> row_start;
    Buffer<BondLink> link;
    Buffer<Vec4<Real>> rest;
    Buffer<Vec4<Real>> spring;
    Buffer<uint32_t> slot_of_bond;  ///< slot at the lower id; bonds of all bodies one after the other
    Buffer<uint32_t> twin;          ///< per slot: the slot at the other end

    BondRowsIn<Real> in() const {
        return {row_start.view(), link.view(), rest.view(), spring.view(), facing};
    }
};

}  // namespace demolish
