// SPDX-License-Identifier: Apache-2.0
// Rows from what was found: sorted by id, with the springs of the rows before.
#pragma once
#include "sim_cuda/backend/bit_count.h"
#include "sim_cuda/kernels/find_pairs.h"

namespace demolish {

/// The rows of the build before, whose tangential springs are carried over.
template <class Real>
struct FormerRows {
    Span<const uint32_t> row_start, neighbour;
    Span<const Vec4<Real>> spring;

    /// Null for a pair that was not listed.
    DEM_FN Vec4<Real> springOf(uint32_t i, uint32_t j) const {
        const uint32_t slot = findContact(row_start, neighbour, i, j);
        return slot < row_start[i + 1] ? spring[slot] : Vec4<Real>{};
    }
};

/// Where rows go. `sums`: exclusive sums of the drafts' counts and then of the counts of all words of
/// projectile bits, the total last.
template <class Real>
struct RowWriter {
    FormerRows<Real> former;
    Span<const uint32_t> sums;
    Span<uint32_t> row_start, neighbour;
    Span<Vec4<Real>> spring;

    DEM_FN bool fits() const { return sums[sums.count - 1] <= neighbour.count; }
    DEM_FN void write(uint32_t slot, uint32_t i, uint32_t j) const {
        neighbour[slot] = j;
        spring[slot] = former.springOf(i, j);
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

/// kThreads threads a row. Writes nothing but row_start where the lists have no room.
template <uint32_t kThreads, class Real>
struct WriteNeighbours {
    NeighbourSearch<Real> search;
    RowWriter<Real> rows;
    RowDrafts drafts;

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = k / kThreads, thread = k % kThreads;
        const uint32_t first = rows.sums[i], length = rows.sums[i + 1] - first;
        if (thread == 0) rows.row_start[i] = first;
        if (length == 0 || !rows.fits()) return;
        const bool apart = search.place_kind[i] == kSetApart;
        const uint32_t* found = apart ? &drafts.long_drafts[size_t{search.place[i]} * drafts.long_length]
                                      : &drafts.neighbour[size_t{i} * drafts.length];
        if (length > (apart ? drafts.long_length : drafts.length)) {
            if (thread == 0) searchAgain(i, first);
        } else if constexpr (kThreads == 1) {
            AppendVisits row{&rows.neighbour[first]};
            for (uint32_t n = 0; n < length; ++n) row(found[n]);
            finish(i, first, row);
        } else {
            for (uint32_t n = thread; n < length; n += kThreads) {
                uint32_t rank = 0;
                for (uint32_t m = 0; m < length; ++m) rank += found[m] < found[n] ? 1u : 0u;
                rows.write(first + rank, i, found[n]);
            }
        }
    }

  private:
    DEM_FN void searchAgain(uint32_t i, uint32_t first) const {
        AppendVisits row{&rows.neighbour[first]};
        const Vec4<Real> position = search.paths.position[i], velocity = search.paths.velocity[i];
        const GridMember<Real> own{i, search.key[i], ballAroundPath(search.frame[0], position, velocity),
                                   position, velocity};
        const auto append = [&](uint32_t at) { row(search.member.id[at]); };
        if (search.place_kind[i] == kSetApart)
            search.visitMembers(own, nullptr, 0, search.members(), append);
        else
            search.visitGrid(own, append);
        search.visitApart(own, append);
        search.visitProjectiles(i, row);
        finish(i, first, row);
    }
    /// Sorts the row and carries its springs over; both rows are ascending.
    DEM_FN void finish(uint32_t i, uint32_t first, const AppendVisits& row) const {
        sortRow(row.row, row.count);
        uint32_t before = rows.former.row_start[i];
        const uint32_t end = rows.former.row_start[i + 1];
        for (uint32_t n = 0; n < row.count; ++n) {
            while (before < end && rows.former.neighbour[before] < row.row[n]) ++before;
            const bool listed = before < end && rows.former.neighbour[before] == row.row[n];
            rows.spring[first + n] = listed ? rows.former.spring[before] : Vec4<Real>{};
        }
    }
};

/// One thread for each projectile slot and particle: words * kBitsPerWord threads a slot.
template <class Real>
struct WriteProjectileRows {
    RowWriter<Real> rows;
    ProjectileBits projectiles;
    uint32_t in_bodies = 0;

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t word = k / kBitsPerWord, bit = k % kBitsPerWord;
        const uint32_t p = word / projectiles.words;
        const uint32_t j = (word - p * projectiles.words) * kBitsPerWord + bit;
        const uint32_t first = rows.sums[in_bodies + word];
        if (j == 0) rows.row_start[in_bodies + p] = first;
        if (k == 0) rows.row_start[rows.row_start.count - 1] = rows.sums[rows.sums.count - 1];
        const uint32_t set = projectiles.bits[word];
        if ((set >> bit & 1u) == 0 || !rows.fits()) return;
        rows.write(first + countBits(set & ((1u << bit) - 1)), in_bodies + p, j);
    }
};

/// All rows: threads 0 .. particle_threads-1 write those of the bodies' particles, the others those of the
/// projectiles.
template <uint32_t kThreads, class Real>
struct WriteRows {
    WriteNeighbours<kThreads, Real> particles;
    WriteProjectileRows<Real> projectiles;
    uint32_t particle_threads = 0;

    DEM_FN void operator()(uint32_t k) const {
        if (k < particle_threads)
            particles(k);
        else
            projectiles(k - particle_threads);
    }
};

}  // namespace demolish
