// The grid's two kernels: count the particles of each bucket, then write their ids bucket by bucket. The
// order inside a bucket is left to chance; the rows made from it are sorted.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/grid_cell.h"

namespace demolish {

template <class Real>
struct CountInBuckets {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    uint32_t mask = 0;
    Span<uint64_t> key;      ///< per particle
    Span<uint32_t> counter;  ///< per bucket, 0 before; the paper's gridCounters
    Span<uint32_t> place;    ///< per particle: its place in the bucket

    DEM_FN void operator()(uint32_t i) const {
        const uint64_t own = cellKey(gridCell(frame[0], paths.position[i], paths.velocity[i]));
        key[i] = own;
        place[i] = atomicAddU32(&counter[bucketOf(own, mask)], 1);
    }
};

template <class Real>
struct FillBuckets {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;  ///< one
    Span<const uint64_t> key;
    Span<const uint32_t> bucket_start;  ///< exclusive sums of the counters
    Span<const uint32_t> place;
    uint32_t mask = 0;
    Span<uint32_t> member;         ///< ids, bucket by bucket; the paper's gridCells
    Span<Vec4<Real>> member_ball;  ///< ballAroundPath of each, so that a bucket is read in one go

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t at = bucket_start[bucketOf(key[i], mask)] + place[i];
        member[at] = i;
        member_ball[at] = ballAroundPath(frame[0], paths.position[i], paths.velocity[i]);
    }
};

}  // namespace demolish
