// The grid's two kernels: count the particles of each bucket, then write their ids bucket by bucket. The
// order inside a bucket is left to chance; the rows made from it are sorted. Enclosed particles stay outside.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/grid_cell.h"

namespace demolish {

template <class Real>
struct CountInBuckets {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    uint32_t mask = 0;
    Span<const uint32_t> enclosed;  ///< per particle
    Span<uint64_t> key;             ///< per particle
    Span<uint32_t> counter;         ///< per bucket, 0 before; the paper's gridCounters
    Span<uint32_t> place;           ///< per particle: its place in the bucket

    DEM_FN void operator()(uint32_t i) const {
        const uint64_t own = cellKey(gridCell(frame[0], paths.position[i], paths.velocity[i]));
        key[i] = own;
        if (enclosed[i] != 0) return;
        place[i] = atomicAddU32(&counter[bucketOf(own, mask)], 1);
    }
};

/// What is known of a particle in its place in the buckets, so that a bucket is read in one go.
template <class Real>
struct GridMembersOut {
    Span<uint32_t> id;                    ///< bucket by bucket; the paper's gridCells
    Span<uint64_t> key;                   ///< of the cell
    Span<Vec4<Real>> ball;                ///< ballAroundPath
    Span<Vec4<Real>> position, velocity;  ///< PathsIn
};

template <class Real>
struct FillBuckets {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    Span<const uint64_t> key;
    Span<const uint32_t> bucket_start;  ///< exclusive sums of the counters
    Span<const uint32_t> place, enclosed;
    uint32_t mask = 0;
    GridMembersOut<Real> member;

    DEM_FN void operator()(uint32_t i) const {
        if (enclosed[i] != 0) return;
        const uint64_t own = key[i];
        const uint32_t at = bucket_start[bucketOf(own, mask)] + place[i];
        const Vec4<Real> position = paths.position[i], velocity = paths.velocity[i];
        member.id[at] = i;
        member.key[at] = own;
        member.ball[at] = ballAroundPath(frame[0], position, velocity);
        member.position[at] = position;
        member.velocity[at] = velocity;
    }
};

}  // namespace demolish
