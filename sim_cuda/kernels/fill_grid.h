// SPDX-License-Identifier: Apache-2.0
// The grid's two kernels: count the particles of each bucket, then write their ids bucket by bucket. The
// order inside a bucket is left to chance; the rows made from it are sorted.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/grid_cell.h"
#include "sim_cuda/kernels/velocity_trim.h"

namespace demolish {

/// Where a particle of a body is looked for: in the buckets; nowhere, since it stands between solid bonds and
/// meets no projectile; among the few that are too fast for the grid.
inline constexpr uint32_t kInGrid = 0, kEnclosed = 1, kSetApart = 2;

template <class Real>
struct CountInBuckets {
    PathsIn<Real> paths;
    Span<const GridFrame<Real>> frame;        ///< one
    Span<const VelocityRanges<Real>> ranges;  ///< one
    Span<const SlowBins> slow;                ///< one
    uint32_t mask = 0;
    Span<uint32_t> place_kind;  ///< per particle: who is set apart is noted here
    Span<uint64_t> key;         ///< per particle
    Span<uint32_t> counter;     ///< per bucket, 0 before; the paper's gridCounters
    Span<uint32_t> apart;       ///< one, 0 before: how many are set apart
    Span<uint32_t> place;       ///< per particle: its place in the bucket, or among those set apart

    DEM_FN void operator()(uint32_t i) const {
        const uint64_t own = cellKey(gridCell(frame[0], paths.position[i], paths.velocity[i]));
        key[i] = own;
        if (place_kind[i] == kEnclosed) return;
        const bool active = hasPath(paths.velocity[i]);
        if (active && frame[0].sets_apart != 0 &&
            isOutside(xyz(paths.velocity[i]), ranges[0].bodies, slow[0])) {
            place_kind[i] = kSetApart;
            place[i] = atomicAddU32(&apart[0], 1);
            return;
        }
        place[i] = atomicAddU32(&counter[bucketOf(own, mask)], 1);
    }
};

/// What is known of a particle in its place in the buckets, so that a bucket is read in one go; those set
/// apart stand after the last bucket.
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
    Span<const uint32_t> place, place_kind;
    uint32_t mask = 0;
    GridMembersOut<Real> member;

    DEM_FN void operator()(uint32_t i) const {
        if (place_kind[i] == kEnclosed) return;
        const uint64_t own = key[i];
        const uint32_t bucket = place_kind[i] == kSetApart ? mask + 1 : bucketOf(own, mask);
        const uint32_t at = bucket_start[bucket] + place[i];
        const Vec4<Real> position = paths.position[i], velocity = paths.velocity[i];
        member.id[at] = i;
        member.key[at] = own;
        member.ball[at] = ballAroundPath(frame[0], position, velocity);
        member.position[at] = position;
        member.velocity[at] = velocity;
    }
};

}  // namespace demolish
