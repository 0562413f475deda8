// Which particles may meet: those of bodies among each other by way of the grid, and each with the
// projectiles. What is found goes into short drafts, in any order; write_neighbours.h makes rows of them.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/grid_cell.h"
#include "sim_cuda/kernels/predicted_path.h"

namespace demolish {

/// Rows of cells about a particle's own: 3 x 3.
inline constexpr uint32_t kCellRows = 9;

/// What all passes read.
template <class Real>
struct NeighbourSearch {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    Span<const uint64_t> key;
    Span<const uint32_t> bucket_start, member;
    Span<const Vec4<Real>> member_ball;
    Span<const uint32_t> bond_row;  ///< total + 1
    Span<const BondLink> link;      ///< sorted by id in each row
    uint32_t mask = 0, in_bodies = 0, total = 0;

    DEM_FN bool takesPart(uint32_t i) const { return paths.velocity[i].w >= Real(0); }
    DEM_FN bool meets(uint32_t i, uint32_t j) const {
        return mayMeet(paths.position[i], paths.velocity[i], paths.position[j], paths.velocity[j],
                       frame[0].horizon);
    }
    /// A pair with a bond record is that record's business, in whatever state it is.
    DEM_FN bool hasBondRecord(uint32_t i, uint32_t j) const {
        uint32_t low = bond_row[i], high = bond_row[i + 1];
        const uint32_t end = high;
        while (low < high) {
            const uint32_t middle = (low + high) / 2;
            if (linkedParticle(link[middle]) < j)
                low = middle + 1;
            else
                high = middle;
        }
        return low < end && linkedParticle(link[low]) == j;
    }

    /// visit(j) for those members first, first + step, ... before `last` that lie in the row of cells and
    /// meet i.
    template <class Visit>
    DEM_FN void visitMembers(uint32_t i, const Vec4<Real>& ball, uint64_t row, uint32_t first, uint32_t last,
                             uint32_t step, Visit& visit) const {
        for (uint32_t at = first; at < last; at += step) {
            if (!ballsTouch(ball, member_ball[at])) continue;
            const uint32_t j = member[at];
            if (j != i && cellRow(key[j]) == row && meets(i, j) && !hasBondRecord(i, j)) visit(j);
        }
    }
    /// visit(j) for every step-th particle of a body in the three cells of row `which` about i's own.
    template <class Visit>
    DEM_FN void visitRow(uint32_t i, const Vec4<Real>& ball, uint32_t which, uint32_t offset, uint32_t step,
                         Visit& visit) const {
        GridCell cell = cellOf(key[i]);
        cell.x -= 1;
        cell.y += static_cast<int32_t>(which % 3) - 1;
        cell.z += static_cast<int32_t>(which / 3) - 1;
        const uint64_t wanted = cellKey(cell);
        const uint32_t bucket = bucketOf(wanted, mask), buckets = mask + 1, end = bucket + 3;
        visitMembers(i, ball, cellRow(wanted), bucket_start[bucket] + offset,
                     bucket_start[end < buckets ? end : buckets], step, visit);
        if (end > buckets)
            visitMembers(i, ball, cellRow(wanted), offset, bucket_start[end - buckets], step, visit);
    }
    /// visit(j) for every neighbour in a body, in any order.
    template <class Visit>
    DEM_FN void visitNeighbours(uint32_t i, const Vec4<Real>& ball, Visit& visit) const {
        for (uint32_t row = 0; row < kCellRows; ++row) visitRow(i, ball, row, 0, 1, visit);
    }
    /// Ascending.
    template <class Visit>
    DEM_FN void visitProjectiles(uint32_t i, Visit& visit) const {
        for (uint32_t p = in_bodies; p < total; ++p)
            if (p != i && takesPart(p) && meets(i, p)) visit(p);
    }
};

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

/// kThreads threads a particle, or one for all rows of cells (1). Threads follow the order of the buckets, so
/// that neighbouring ones read the same members.
template <uint32_t kThreads, class Real>
struct FindNeighbours {
    static_assert(kThreads == 1 || kThreads % kCellRows == 0);
    NeighbourSearch<Real> search;
    RowDrafts drafts;

    struct Append {
        RowDrafts drafts;
        uint32_t i, count;
        DEM_FN void operator()(uint32_t j) {
            if constexpr (kThreads == 1)
                drafts.put(i, count++, j);
            else
                drafts.put(i, atomicAddU32(&drafts.count[i], 1), j);
        }
    };

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t at = k / kThreads, part = k % kThreads;
        Append append{drafts, search.member[at], 0};
        const Vec4<Real> ball = search.member_ball[at];
        if constexpr (kThreads == 1) {
            search.visitNeighbours(append.i, ball, append);
            drafts.count[append.i] = append.count;
        } else {
            constexpr uint32_t kStep = kThreads / kCellRows;
            search.visitRow(append.i, ball, part / kStep, part % kStep, kStep, append);
        }
    }
};

}  // namespace demolish
