// Rows of the projectiles. They are few and may touch thousands, so that a row is made by many threads: one
// for each chunk of particles, counting first and writing into its own part of the row, hence in order of
// ids.
#pragma once
#include "sim_cuda/kernels/find_neighbours.h"

namespace demolish {

inline constexpr uint32_t kProjectileChunk = 256;

/// Thread k: projectile k / chunks against chunk k % chunks of all particles, the projectiles included.
template <class Real>
struct ProjectileSearch {
    NeighbourSearch<Real> search;
    uint32_t chunks = 0;  ///< per projectile

    DEM_FN uint32_t projectile(uint32_t k) const { return search.in_bodies + k / chunks; }
    template <class Visit>
    DEM_FN void visitChunk(uint32_t k, Visit& visit) const {
        const uint32_t p = projectile(k), first = (k % chunks) * kProjectileChunk;
        if (!search.takesPart(p)) return;
        const uint32_t last = minOf(first + kProjectileChunk, search.total);
        for (uint32_t j = first; j < last; ++j)
            if (j != p && search.takesPart(j) && search.meets(p, j)) visit(j);
    }
};

template <class Real>
struct CountProjectileChunks {
    ProjectileSearch<Real> search;
    Span<uint32_t> count;  ///< per projectile and chunk

    DEM_FN void operator()(uint32_t k) const {
        CountVisits visits;
        search.visitChunk(k, visits);
        count[k] = visits.count;
    }
};

/// Row lengths of the projectiles from the sums over their chunks.
struct CountProjectileRows {
    Span<const uint32_t> chunk_start;  ///< exclusive sums of the chunks' counts
    uint32_t chunks = 0, in_bodies = 0;
    Span<uint32_t> count;  ///< per particle

    DEM_FN void operator()(uint32_t p) const {
        count[in_bodies + p] = chunk_start[(p + 1) * chunks] - chunk_start[p * chunks];
    }
};

template <class Real>
struct WriteProjectileRows {
    ProjectileSearch<Real> search;
    FormerRows<Real> former;
    Span<const uint32_t> chunk_start, row_start;
    Span<uint32_t> neighbour;
    Span<Vec4<Real>> spring;

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t p = search.projectile(k);
        const uint32_t first = row_start[p] + chunk_start[k] - chunk_start[k - k % search.chunks];
        AppendVisits row{&neighbour[first]};
        search.visitChunk(k, row);
        for (uint32_t n = 0; n < row.count; ++n) spring[first + n] = former.springOf(p, row.row[n]);
    }
};

}  // namespace demolish
