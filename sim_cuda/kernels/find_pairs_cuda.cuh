// SPDX-License-Identifier: Apache-2.0
// The search on the GPU: a warp for each particle. Most candidates fail the first test and few pass; those
// that pass are gathered in a queue and looked at together, else every lane would wait for the few.
#pragma once
#include "sim_cuda/backend/cuda_chained_launch.cuh"
#include "sim_cuda/kernels/find_pairs.h"
#include "sim_cuda/kernels/velocity_trim.h"

namespace demolish {

inline constexpr uint32_t kSearchBlock = 128, kSearchWarps = kSearchBlock / 32;
/// Bond records of a particle that are kept at hand; longer rows are read where they are.
inline constexpr uint32_t kRecordsAtHand = 32;

/// What a warp keeps in shared memory.
template <class Real>
struct WarpMemory {
    /// Members that each lane asks for at once; room for those that pass, and for up to 32 that wait.
    static constexpr uint32_t kAtOnce = 3, kQueue = 32 * (kAtOnce + 1);
    struct Candidate {
        uint32_t at;  ///< place in the buckets
        uint32_t row;
    };
    uint4 records[kRecordsAtHand / 4];
    Candidate queue[kQueue];
    uint32_t found;
};

/// One warp and the member that it searches for.
template <class Real>
class WarpSearch {
  public:
    __device__ WarpSearch(const NeighbourSearch<Real>& search, const RowDrafts& drafts, uint32_t member,
                          uint32_t lane, WarpMemory<Real>& memory)
        : search_(search),
          drafts_(drafts),
          member_(member),
          lane_(lane),
          memory_(memory),
          own_(search.member[member]),
          first_record_(search.bond_row[own_.id]),
          record_count_(search.bond_row[own_.id + 1] - first_record_) {
        static_assert(kRecordsAtHand == 32);
        if (lane == 0) memory_.found = 0;
        reinterpret_cast<uint32_t*>(memory_.records)[lane] =
            lane < record_count_ ? linkedParticle(search.link[first_record_ + lane]) : kNobody;
        __syncwarp();
    }

    /// All neighbours in bodies; of those set apart only those that are set apart too.
    __device__ void run() {
        visit(piecesAbout(own_.key));
        drain();
    }
    /// The projectiles, and the lengths of the rows.
    __device__ void finish(const ProjectileBits& projectiles) {
        for (uint32_t p = search_.in_bodies + lane_; p < search_.total; p += 32) {
            if (!search_.takesPart(p) || !search_.takesPart(own_.id) || !search_.meetsProjectile(own_.id, p))
                continue;
            markProjectile(projectiles, p - search_.in_bodies, own_.id);
            append(p);
        }
        __syncwarp();
        if (!isApart() && lane_ == 0) drafts_.count[own_.id] = memory_.found;
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
    __device__ void visit(const Piece& about) {
        constexpr uint32_t kAtOnce = WarpMemory<Real>::kAtOnce;
        Walk walk{__ballot_sync(kAll, about.first < about.last)};
        const Vec4<Real> own_ball = own_.ball;
        for (bool more = true; more;) {
            uint32_t at[kAtOnce], row[kAtOnce];
            bool present[kAtOnce];
            Vec4<Real> ball[kAtOnce];
#pragma unroll
            for (uint32_t b = 0; b < kAtOnce; ++b) {
                more = walk.next(about);
                at[b] = walk.base + lane_;
                row[b] = walk.row;
                present[b] = at[b] < walk.end;
                ball[b] = search_.member.ball[present[b] ? at[b] : 0];
            }
#pragma unroll
            for (uint32_t b = 0; b < kAtOnce; ++b)
                queueUp(present[b] && ballsTouch(own_ball, ball[b]), at[b], row[b]);
            if (queued_ > 32) drain();
        }
    }
    __device__ __forceinline__ void queueUp(bool passes, uint32_t at, uint32_t row) {
        const unsigned chosen = __ballot_sync(kAll, passes);
        if (passes) memory_.queue[queued_ + __popc(chosen & ((1u << lane_) - 1))] = {at, row};
        queued_ += __popc(chosen);
    }
    __device__ void drain() {
        __syncwarp();
        for (uint32_t k = lane_; k < queued_; k += 32) lookAt(memory_.queue[k]);
        queued_ = 0;
        __syncwarp();
    }
    __device__ __forceinline__ void lookAt(const typename WarpMemory<Real>::Candidate& candidate) const {
        const GridMember<Real> other = search_.member[candidate.at];  // all of it at the same time
        if (!isInRow(other.key, candidate.row) || !search_.meets(own_, other) || hasRecord(other.id)) return;
        append(other.id);
        if (candidate.row == kCellRows && !isApart())
            drafts_.putApart(other.id, candidate.at - search_.members(), own_.id);
    }
    /// Row kCellRows: all those set apart.
    __device__ bool isInRow(uint64_t key, uint32_t which) const {
        const GridCell centre = cellOf(own_.key), cell = cellOf(key);
        return which == kCellRows || (cell.y == centre.y + static_cast<int32_t>(which % 3) - 1 &&
                                      cell.z == centre.z + static_cast<int32_t>(which / 3) - 1);
    }
    __device__ bool isApart() const {
        return member_ >= search_.members();
    }
    __device__ bool hasRecord(uint32_t j) const {
        if (record_count_ > kRecordsAtHand) return search_.hasBondRecord(own_.id, j);
        bool found = false;
        for (uint32_t k = 0; 4 * k < record_count_; ++k) {
            const uint4 four = memory_.records[k];
            found = found || four.x == j || four.y == j || four.z == j || four.w == j;
        }
        return found;
    }
    __device__ void append(uint32_t j) const {
        if (isApart())
            drafts_.putApart(own_.id, member_ - search_.members(), j);
        else
            drafts_.put(own_.id, atomicAddU32(&memory_.found, 1), j);
    }

    const NeighbourSearch<Real>& search_;
    const RowDrafts& drafts_;
    const uint32_t member_, lane_;
    WarpMemory<Real>& memory_;
    const GridMember<Real> own_;
    const uint32_t first_record_, record_count_;
    uint32_t queued_ = 0;
};

/// Warps of a search among so many particles: members of the buckets, those set apart, projectile slots.
DEM_FN uint32_t searchWarps(uint32_t in_bodies, uint32_t shots) {
    return in_bodies + kMostFast + shots;
}

template <class Real>
__global__ void __launch_bounds__(kSearchBlock)
    findPairsKernel(const NeighbourSearch<Real> search, const RowDrafts drafts,
                    const ProjectileBits projectiles) {
    __shared__ WarpMemory<Real> memory[kSearchWarps];
    letNextStart();
    awaitPrevious();
    const uint32_t lane = threadIdx.x % 32, warp = blockIdx.x * kSearchWarps + threadIdx.x / 32;
    const uint32_t for_bodies = searchWarps(search.in_bodies, 0);
    if (warp >= for_bodies) {
        const uint32_t shot = search.in_bodies + (warp - for_bodies);
        if (shot >= search.total || !search.takesPart(shot)) return;
        for (uint32_t p = search.in_bodies + lane; p < search.total; p += 32)
            if (search.meetsProjectile(shot, p)) markProjectile(projectiles, p - search.in_bodies, shot);
        return;
    }
    if (warp >= search.allMembers()) return;  // those of the buckets, then those set apart
    WarpSearch<Real> own(search, drafts, warp, lane, memory[threadIdx.x / 32]);
    own.run();
    own.finish(projectiles);
}

}  // namespace demolish
