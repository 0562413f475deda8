// SPDX-License-Identifier: Apache-2.0
// Pairs that turn up while contact lists hold: whoever has left his path may touch somebody whom his row does
// not name. The rows are copied with the new pairs at their places; nobody else is searched for.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/write_neighbours.h"

namespace demolish {

/// Of both ends of a pair each needs the other in its row.
inline constexpr uint32_t kMostInserted = 1024;

/// An entry of a row, so that entries sort by (row, id).
DEM_FN uint64_t rowEntry(uint32_t row, uint32_t id) {
    return uint64_t{row} << 32 | id;
}

/// Entries in any order. Above kMostInserted they are counted but not kept.
struct NewEntries {
    Span<uint64_t> entry;  ///< kMostInserted
    Span<uint32_t> count;  ///< one word

    DEM_FN void add(uint32_t row, uint32_t id) const {
        const uint32_t place = atomicAddU32(&count[0], 1);
        if (place < kMostInserted) entry[place] = rowEntry(row, id);
    }
};

/// One thread an entry; no two are equal.
struct SortEntries {
    Span<const uint64_t> entry;
    Span<uint64_t> sorted;
    uint32_t count = 0;

    DEM_FN void operator()(uint32_t k) const {
        uint32_t rank = 0;
        for (uint32_t other = 0; other < count; ++other) rank += entry[other] < entry[k] ? 1u : 0u;
        sorted[rank] = entry[k];
    }
};

/// kThreads threads a row, and as many for the end of the last: rows 0 .. rows.
template <uint32_t kThreads, class Real>
struct CopyRowsWith {
    FormerRows<Real> former;
    Span<const uint64_t> sorted;  ///< the new entries
    Span<uint32_t> row_start, neighbour;
    Span<Vec4<Real>> spring;
    uint32_t rows = 0;

    DEM_FN void operator()(uint32_t thread) const {
        const uint32_t i = thread / kThreads, part = thread % kThreads;
        const uint32_t first_new = entriesBefore(rowEntry(i, 0)), from = former.row_start[i];
        const uint32_t to = from + first_new;
        if (part == 0) row_start[i] = to;
        if (i == rows) return;
        const uint32_t last_new = entriesBefore(rowEntry(i + 1, 0)), end = former.row_start[i + 1];
        for (uint32_t slot = from + part; slot < end; slot += kThreads) {
            const uint32_t j = former.neighbour[slot];
            uint32_t before = 0;
            for (uint32_t k = first_new; k < last_new; ++k) before += idOf(k) < j ? 1u : 0u;
            neighbour[to + (slot - from) + before] = j;
            spring[to + (slot - from) + before] = former.spring[slot];
        }
        for (uint32_t k = first_new + part; k < last_new; k += kThreads) {
            const uint32_t before =
                firstNotBelow(from, end, idOf(k), [&](uint32_t slot) { return former.neighbour[slot]; });
            const uint32_t at = to + (before - from) + (k - first_new);
            neighbour[at] = idOf(k);
            spring[at] = Vec4<Real>{};
        }
    }

  private:
    DEM_FN uint32_t idOf(uint32_t k) const { return static_cast<uint32_t>(sorted[k]); }
    DEM_FN uint32_t entriesBefore(uint64_t wanted) const {
        return firstNotBelow(0, static_cast<uint32_t>(sorted.count), wanted,
                             [&](uint32_t k) { return sorted[k]; });
    }
};

}  // namespace demolish
