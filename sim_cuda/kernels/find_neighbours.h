// SPDX-License-Identifier: Apache-2.0
// Which particles may meet: those of bodies among each other by way of the grid, and each with the
// projectiles. find_pairs.h keeps what is found.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/fill_grid.h"
#include "sim_cuda/kernels/predicted_path.h"

namespace demolish {

/// Rows of cells about a particle's own: 3 x 3.
inline constexpr uint32_t kCellRows = 9;

/// One particle and its path.
template <class Real>
struct GridMember {
    uint32_t id = 0;
    uint64_t key = 0;
    Vec4<Real> ball, position, velocity;
};

/// All of them, bucket by bucket (fill_grid.h).
template <class Real>
struct GridMembersIn {
    Span<const uint32_t> id;
    Span<const uint64_t> key;
    Span<const Vec4<Real>> ball, position, velocity;

    DEM_FN GridMember<Real> operator[](uint32_t at) const {
        return {id[at], key[at], ball[at], position[at], velocity[at]};
    }
};

/// Three neighbouring cells: members first .. last-1, and 0 .. wrapped-1 where the last bucket is followed by
/// the first. Strangers of other rows may be among them.
struct RowOfCells {
    uint64_t row = 0;
    uint32_t first = 0, last = 0, wrapped = 0;
};

/// What all passes read.
template <class Real>
struct NeighbourSearch {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    Span<const uint64_t> key;
    Span<const uint32_t> bucket_start;
    GridMembersIn<Real> member;
    Span<const uint32_t> bond_row;           ///< total + 1
    Span<const BondLink> link;               ///< sorted by id in each row
    Span<const uint32_t> place_kind, place;  ///< per particle of a body
    Span<const uint32_t> apart;              ///< one: how many are set apart
    uint32_t mask = 0, in_bodies = 0, total = 0;

    /// Members of all buckets; after them come those set apart.
    DEM_FN uint32_t members() const { return bucket_start[mask + 1]; }
    DEM_FN uint32_t allMembers() const { return members() + apart[0]; }
    DEM_FN bool takesPart(uint32_t i) const { return hasPath(paths.velocity[i]); }
    DEM_FN bool meets(uint32_t i, uint32_t j) const {
        return mayMeet(paths.position[i], paths.velocity[i], paths.position[j], paths.velocity[j],
                       frame[0].horizon);
    }
    /// A pair with a bond record is that record's business, in whatever state it is.
    DEM_FN bool hasBondRecord(uint32_t i, uint32_t j) const {
        return findBond(bond_row, link, i, j) < bond_row[i + 1];
    }

    /// Row `which` of the cells about a particle's own.
    DEM_FN RowOfCells rowAbout(uint64_t own_key, uint32_t which) const {
        GridCell cell = cellOf(own_key);
        cell.x -= 1;
        cell.y += static_cast<int32_t>(which % 3) - 1;
        cell.z += static_cast<int32_t>(which / 3) - 1;
        const uint64_t wanted = cellKey(cell);
        const uint32_t bucket = bucketOf(wanted, mask), buckets = mask + 1, end = bucket + 3;
        return {cellRow(wanted), bucket_start[bucket], bucket_start[end < buckets ? end : buckets],
                end > buckets ? bucket_start[end - buckets] : 0};
    }
    /// May the two touch, by their paths alone?
    DEM_FN bool meets(const GridMember<Real>& own, const GridMember<Real>& other) const {
        return other.id != own.id &&
               mayMeet(own.position, own.velocity, other.position, other.velocity, frame[0].horizon);
    }
    /// visit(at) for those members first .. last-1 that meet `own`, have no bond record with it, and lie in
    /// the row of cells, if there is one.
    template <class Visit>
    DEM_FN void visitMembers(const GridMember<Real>& own, const uint64_t* row, uint32_t first, uint32_t last,
                             Visit& visit) const {
        for (uint32_t at = first; at < last; ++at)
            if (ballsTouch(own.ball, member.ball[at]) && meets(own, member[at]) &&
                (row == nullptr || cellRow(member.key[at]) == *row) && !hasBondRecord(own.id, member.id[at]))
                visit(at);
    }
    /// visit(at) for every neighbour in the buckets, in any order.
    template <class Visit>
    DEM_FN void visitGrid(const GridMember<Real>& own, Visit& visit) const {
        for (uint32_t which = 0; which < kCellRows; ++which) {
            const RowOfCells row = rowAbout(own.key, which);
            visitMembers(own, &row.row, row.first, row.last, visit);
            visitMembers(own, &row.row, 0, row.wrapped, visit);
        }
    }
    /// visit(at) for every neighbour among those set apart.
    template <class Visit>
    DEM_FN void visitApart(const GridMember<Real>& own, Visit& visit) const {
        visitMembers(own, nullptr, members(), allMembers(), visit);
    }
    DEM_FN bool meetsProjectile(uint32_t i, uint32_t p) const {
        return p != i && takesPart(p) && meets(i, p);
    }
    /// visit(p) for every projectile, ascending.
    template <class Visit>
    DEM_FN void visitProjectiles(uint32_t i, Visit& visit) const {
        for (uint32_t p = in_bodies; p < total; ++p)
            if (meetsProjectile(i, p)) visit(p);
    }
};

}  // namespace demolish
