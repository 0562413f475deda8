// Rows of the bodies' particles: count them, then write them sorted by id, with the projectiles at the end.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/grid_cell.h"
#include "sim_cuda/kernels/predicted_path.h"

namespace demolish {

/// What both passes read.
template <class Real>
struct NeighbourSearch {
    PathsIn<Real> paths;
    Span<const uint64_t> key;
    Span<const uint32_t> bucket_start, member;
    Span<const Vec4<Real>> member_position, member_velocity;
    Span<const uint32_t> bond_row;  ///< total + 1
    Span<const BondLink> link;      ///< sorted by id in each row
    Real horizon{};                 ///< s
    uint32_t mask = 0, in_bodies = 0, total = 0;

    DEM_FN bool takesPart(uint32_t i) const { return paths.velocity[i].w >= Real(0); }
    DEM_FN bool meets(uint32_t i, uint32_t j) const {
        return mayMeet(paths.position[i], paths.velocity[i], paths.position[j], paths.velocity[j], horizon);
    }
    /// A pair with a bond record is that record's business, in whatever state it is.
    DEM_FN bool hasBondRecord(uint32_t i, uint32_t j) const {
        for (uint32_t slot = bond_row[i]; slot < bond_row[i + 1]; ++slot)
            if (linkedParticle(link[slot]) == j) return true;
        return false;
    }

    /// visit(j) for every particle of a body in the cell, in any order.
    template <class Visit>
    DEM_FN void visitCell(uint32_t i, const GridCell& cell, Visit& visit) const {
        const uint64_t wanted = cellKey(cell);
        const uint32_t bucket = bucketOf(wanted, mask);
        const Vec4<Real> x = paths.position[i], v = paths.velocity[i];
        for (uint32_t at = bucket_start[bucket]; at < bucket_start[bucket + 1]; ++at) {
            if (!mayMeet(x, v, member_position[at], member_velocity[at], horizon)) continue;
            const uint32_t j = member[at];
            if (j != i && key[j] == wanted && !hasBondRecord(i, j)) visit(j);
        }
    }
    template <class Visit>
    DEM_FN void visitNeighbours(uint32_t i, Visit& visit) const {
        const GridCell own = cellOf(key[i]);
        for (int32_t z = -1; z <= 1; ++z)
            for (int32_t y = -1; y <= 1; ++y)
                for (int32_t x = -1; x <= 1; ++x) visitCell(i, {own.x + x, own.y + y, own.z + z}, visit);
    }
    /// Ascending.
    template <class Visit>
    DEM_FN void visitProjectiles(uint32_t i, Visit& visit) const {
        for (uint32_t p = in_bodies; p < total; ++p)
            if (p != i && takesPart(p) && meets(i, p)) visit(p);
    }
};

struct CountVisits {
    uint32_t count = 0;
    DEM_FN void operator()(uint32_t) { ++count; }
};

/// Rows up to this length are kept from the first pass; longer ones are searched twice.
inline constexpr uint32_t kDraftLength = 24;

struct DraftVisits {
    uint32_t* draft = nullptr;
    uint32_t count = 0;
    DEM_FN void operator()(uint32_t j) {
        if (count < kDraftLength) draft[count] = j;
        ++count;
    }
};

struct AppendVisits {
    uint32_t* row = nullptr;
    uint32_t count = 0;
    DEM_FN void operator()(uint32_t j) { row[count++] = j; }
};

/// Rows are short: insertion.
DEM_FN void sortRow(uint32_t* row, uint32_t count) {
    for (uint32_t k = 1; k < count; ++k) {
        const uint32_t value = row[k];
        uint32_t at = k;
        for (; at > 0 && row[at - 1] > value; --at) row[at] = row[at - 1];
        row[at] = value;
    }
}

template <class Real>
struct CountNeighbours {
    NeighbourSearch<Real> search;
    Span<uint32_t> count;
    Span<uint32_t> draft;  ///< kDraftLength words a particle

    DEM_FN void operator()(uint32_t i) const {
        DraftVisits visits{&draft[size_t{i} * kDraftLength]};
        search.visitNeighbours(i, visits);
        search.visitProjectiles(i, visits);
        count[i] = visits.count;
    }
};

/// The rows of the build before, whose tangential springs are carried over.
template <class Real>
struct FormerRows {
    Span<const uint32_t> row_start, neighbour;
    Span<const Vec4<Real>> spring;

    /// Null for a pair that was not listed.
    DEM_FN Vec4<Real> springOf(uint32_t i, uint32_t j) const {
        uint32_t low = row_start[i], high = row_start[i + 1];
        const uint32_t end = high;
        while (low < high) {
            const uint32_t middle = (low + high) / 2;
            if (neighbour[middle] < j)
                low = middle + 1;
            else
                high = middle;
        }
        return low < end && neighbour[low] == j ? spring[low] : Vec4<Real>{};
    }
};

template <class Real>
struct WriteNeighbours {
    NeighbourSearch<Real> search;
    FormerRows<Real> former;
    Span<const uint32_t> row_start;
    Span<const uint32_t> draft;
    Span<uint32_t> neighbour;
    Span<Vec4<Real>> spring;

    DEM_FN void operator()(uint32_t i) const {
        AppendVisits row{&neighbour[row_start[i]]};
        const uint32_t length = row_start[i + 1] - row_start[i];
        if (length > kDraftLength) {
            search.visitNeighbours(i, row);
            sortRow(row.row, row.count);
            search.visitProjectiles(i, row);
        } else {
            for (uint32_t k = 0; k < length; ++k) row(draft[size_t{i} * kDraftLength + k]);
            sortRow(row.row, row.count);  // projectiles have the highest ids
        }
        for (uint32_t k = 0; k < row.count; ++k) spring[row_start[i] + k] = former.springOf(i, row.row[k]);
    }
};

}  // namespace demolish
