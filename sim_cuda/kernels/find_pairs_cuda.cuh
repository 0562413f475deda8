// SPDX-License-Identifier: Apache-2.0
// The search on the GPU: a warp for some particles that follow each other in the buckets, most of them of one
// cell, so that what lies about them is read once. Most candidates fail the first test and few pass; those
// who pass are gathered in a queue and looked at together, else every lane would wait for the few.
#pragma once
#include "sim_cuda/backend/cuda_chained_launch.cuh"
#include "sim_cuda/kernels/find_pairs.h"
#include "sim_cuda/kernels/velocity_trim.h"

namespace demolish {

inline constexpr uint32_t kSearchBlock = 128, kSearchWarps = kSearchBlock / 32;
/// Bond records of a particle that are kept at hand; longer rows are read where they are.
inline constexpr uint32_t kRecordsAtHand = 32;

/// What a warp keeps in shared memory for kGroup particles.
template <uint32_t kGroup, class Real>
struct WarpMemory {
    /// Members that each lane asks for at once; room for those that pass, and for up to 32 that wait.
    static constexpr uint32_t kAtOnce = 3, kQueue = 32 * (kAtOnce + 1);
    struct Candidate {
        uint32_t at;  ///< place in the buckets
        uint32_t row_and_group;
    };
    alignas(16) unsigned char own[kGroup * sizeof(GridMember<Real>)];
    uint4 records[kGroup][kRecordsAtHand / 4];
    Candidate queue[kQueue];
    uint32_t record_count[kGroup], found[kGroup];
};

/// One warp and the particles that it searches for: members first .. first + count - 1.
template <uint32_t kGroup, class Real>
class WarpSearch {
  public:
    __device__ WarpSearch(const NeighbourSearch<Real>& search, const RowDrafts& drafts, uint32_t first,
                          uint32_t count, uint32_t lane, WarpMemory<kGroup, Real>& memory)
        : search_(search),
          drafts_(drafts),
          first_(first),
          count_(count),
          lane_(lane),
          memory_(memory),
          own_(reinterpret_cast<GridMember<Real>*>(memory.own)) {
        static_assert(kRecordsAtHand == 32);
        if (lane < count) {
            own_[lane] = search.member[first + lane];
            memory_.found[lane] = 0;
        }
        __syncwarp();
        for (uint32_t g = 0; g < count; ++g) {
            const uint32_t begin = search.bond_row[own_[g].id], end = search.bond_row[own_[g].id + 1];
            auto* records = reinterpret_cast<uint32_t*>(memory_.records[g]);
            records[lane] = begin + lane < end ? linkedParticle(search.link[begin + lane]) : kNobody;
            if (lane == 0) memory_.record_count[g] = end - begin;
        }
        __syncwarp();
    }

    /// All neighbours in bodies; of those set apart only those that are set apart too.
    __device__ void run() {
        for (uint32_t from = 0, to; from < count_; from = to) {
            const uint64_t cell = own_[from].key;
            for (to = from + 1; to < count_ && own_[to].key == cell;) ++to;
            visit(piecesAbout(cell), from, to);
        }
        drain();
    }
    /// The projectiles, and the lengths of the rows.
    __device__ void finish(const ProjectileBits& projectiles) {
        for (uint32_t p = search_.in_bodies + lane_; p < search_.total; p += 32) {
            if (!search_.takesPart(p)) continue;
            for (uint32_t g = 0; g < count_; ++g) {
                if (!search_.takesPart(own_[g].id) || !search_.meetsProjectile(own_[g].id, p)) continue;
                markProjectile(projectiles, p - search_.in_bodies, own_[g].id);
                append(g, p);
            }
        }
        __syncwarp();
        if (!isApart() && lane_ < count_) drafts_.count[own_[lane_].id] = memory_.found[lane_];
    }

  private:
    static constexpr unsigned kAll = 0xffffffffu;
    static constexpr uint32_t kNobody = 0xffffffffu;

    /// Of a lane: members first .. last - 1. Lanes 0 to 8 have the rows of cells, nine more what these have
    /// at the beginning of the buckets, one those set apart.
    struct Piece {
        uint32_t first = 0, last = 0;
    };
    __device__ Piece piecesAbout(uint64_t cell) const {
        RowOfCells row;
        if (lane_ < kCellRows && !isApart()) row = search_.rowAbout(cell, lane_);
        const uint32_t wrapped = __shfl_sync(kAll, row.wrapped, (lane_ - kCellRows) % 32);
        if (lane_ < kCellRows) return {row.first, row.last};
        if (lane_ < 2 * kCellRows) return {0, wrapped};
        if (lane_ == 2 * kCellRows) return {search_.members(), search_.allMembers()};
        return {};
    }
    /// Goes through the pieces of all lanes, 32 members at a time; the same in all lanes.
    struct Walk {
        unsigned left;  ///< pieces to come
        uint32_t base = 0, end = 0, row = 0;

        __device__ bool next(const Piece& own) {
            base += 32;
            if (base < end) return true;
            base = end = 0;
            if (left == 0) return false;
            const uint32_t piece = __ffs(static_cast<int>(left)) - 1;
            left &= left - 1;
            base = __shfl_sync(kAll, own.first, piece);
            end = __shfl_sync(kAll, own.last, piece);
            row = piece < kCellRows ? piece : piece < 2 * kCellRows ? piece - kCellRows : kCellRows;
            return true;
        }
    };
    __device__ void visit(const Piece& own, uint32_t from, uint32_t to) {
        constexpr uint32_t kAtOnce = WarpMemory<kGroup, Real>::kAtOnce;
        Walk walk{__ballot_sync(kAll, own.first < own.last)};
        for (bool more = true; more;) {
            uint32_t at[kAtOnce], row[kAtOnce];
            bool present[kAtOnce];
            Vec4<Real> ball[kAtOnce];
#pragma unroll
            for (uint32_t b = 0; b < kAtOnce; ++b) {
                more = walk.next(own);
                at[b] = walk.base + lane_;
                row[b] = walk.row;
                present[b] = at[b] < walk.end;
                ball[b] = search_.member.ball[present[b] ? at[b] : 0];
            }
            for (uint32_t g = from; g < to; ++g) {
                const Vec4<Real> own_ball = own_[g].ball;
#pragma unroll
                for (uint32_t b = 0; b < kAtOnce; ++b)
                    queueUp(present[b] && ballsTouch(own_ball, ball[b]), at[b], row[b] * kGroup + g);
                if (queued_ > 32) drain();
            }
        }
    }
    __device__ __forceinline__ void queueUp(bool passes, uint32_t at, uint32_t row_and_group) {
        const unsigned chosen = __ballot_sync(kAll, passes);
        if (passes) memory_.queue[queued_ + __popc(chosen & ((1u << lane_) - 1))] = {at, row_and_group};
        queued_ += __popc(chosen);
    }
    __device__ void drain() {
        __syncwarp();
        for (uint32_t k = lane_; k < queued_; k += 32) lookAt(memory_.queue[k]);
        queued_ = 0;
        __syncwarp();
    }
    __device__ __forceinline__ void lookAt(
        const typename WarpMemory<kGroup, Real>::Candidate& candidate) const {
        const uint32_t g = candidate.row_and_group % kGroup, row = candidate.row_and_group / kGroup;
        const GridMember<Real>& own = own_[g];
        const GridMember<Real> other = search_.member[candidate.at];  // all of it at the same time
        if (!isInRow(own, other.key, row) || !search_.meets(own, other) || hasRecord(g, other.id)) return;
        append(g, other.id);
        if (row == kCellRows && !isApart())
            drafts_.putApart(other.id, candidate.at - search_.members(), own.id);
    }
    /// Row kCellRows: all those set apart.
    __device__ bool isInRow(const GridMember<Real>& own, uint64_t key, uint32_t which) const {
        const GridCell centre = cellOf(own.key), cell = cellOf(key);
        return which == kCellRows || (cell.y == centre.y + static_cast<int32_t>(which % 3) - 1 &&
                                      cell.z == centre.z + static_cast<int32_t>(which / 3) - 1);
    }
    __device__ bool isApart() const {
        return first_ >= search_.members();
    }
    __device__ bool hasRecord(uint32_t g, uint32_t j) const {
        const uint32_t count = memory_.record_count[g];
        if (count > kRecordsAtHand) return search_.hasBondRecord(own_[g].id, j);
        bool found = false;
        for (uint32_t k = 0; 4 * k < count; ++k) {
            const uint4 four = memory_.records[g][k];
            found = found || four.x == j || four.y == j || four.z == j || four.w == j;
        }
        return found;
    }
    __device__ void append(uint32_t g, uint32_t j) const {
        if (isApart())
            drafts_.putApart(own_[g].id, first_ + g - search_.members(), j);
        else
            drafts_.put(own_[g].id, atomicAddU32(&memory_.found[g], 1), j);
    }

    const NeighbourSearch<Real>& search_;
    const RowDrafts& drafts_;
    const uint32_t first_, count_, lane_;
    WarpMemory<kGroup, Real>& memory_;
    GridMember<Real>* own_;
    uint32_t queued_ = 0;
};

/// Groups of kGroup members.
template <uint32_t kGroup>
DEM_FN uint32_t groupsOf(uint32_t members) {
    return (members + kGroup - 1) / kGroup;
}
/// Warps of a search among so many particles: members of the buckets, those set apart, projectile slots.
template <uint32_t kGroup>
DEM_FN uint32_t searchWarps(uint32_t in_bodies, uint32_t shots) {
    return groupsOf<kGroup>(in_bodies) + groupsOf<kGroup>(kMostFast) + shots;
}

template <uint32_t kGroup, class Real>
__global__ void __launch_bounds__(kSearchBlock)
    findPairsKernel(const NeighbourSearch<Real> search, const RowDrafts drafts,
                    const ProjectileBits projectiles) {
    __shared__ WarpMemory<kGroup, Real> memory[kSearchWarps];
    letNextStart();
    awaitPrevious();
    const uint32_t lane = threadIdx.x % 32, warp = blockIdx.x * kSearchWarps + threadIdx.x / 32;
    const uint32_t for_bodies = searchWarps<kGroup>(search.in_bodies, 0);
    if (warp >= for_bodies) {
        const uint32_t shot = search.in_bodies + (warp - for_bodies);
        if (shot >= search.total || !search.takesPart(shot)) return;
        for (uint32_t p = search.in_bodies + lane; p < search.total; p += 32)
            if (search.meetsProjectile(shot, p)) markProjectile(projectiles, p - search.in_bodies, shot);
        return;
    }
    const uint32_t members = search.members(), in_grid = groupsOf<kGroup>(members);
    const bool apart = warp >= in_grid;
    const uint32_t first = apart ? members + (warp - in_grid) * kGroup : warp * kGroup;
    const uint32_t end = apart ? search.allMembers() : members;
    if (first >= end) return;
    const uint32_t count = end - first < kGroup ? end - first : kGroup;
    WarpSearch<kGroup, Real> own(search, drafts, first, count, lane, memory[threadIdx.x / 32]);
    own.run();
    own.finish(projectiles);
}

}  // namespace demolish
