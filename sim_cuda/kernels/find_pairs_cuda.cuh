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
    static constexpr uint32_t kQueue = 64;
    struct Candidate {
        uint32_t at;     ///< place in the buckets
        uint32_t group;  ///< particle of the group
        uint32_t which;  ///< row of cells
    };
    alignas(16) unsigned char own[kGroup * sizeof(GridMember<Real>)];
    Candidate queue[kQueue];
    uint32_t records[kGroup][kRecordsAtHand], record_count[kGroup], found[kGroup];
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
        if (lane < count) {
            own_[lane] = search.member[first + lane];
            memory_.found[lane] = 0;
        }
        __syncwarp();
        for (uint32_t g = 0; g < count; ++g) {
            const uint32_t begin = search.bond_row[own_[g].id], end = search.bond_row[own_[g].id + 1];
            if (begin + lane < end && lane < kRecordsAtHand)
                memory_.records[g][lane] = linkedParticle(search.link[begin + lane]);
            if (lane == 0) memory_.record_count[g] = end - begin;
        }
        __syncwarp();
    }

    /// All neighbours in bodies of members of the buckets.
    __device__ void run() {
        for (uint32_t from = 0, to; from < count_; from = to) {
            const uint64_t cell = own_[from].key;
            for (to = from + 1; to < count_ && own_[to].key == cell;) ++to;
            RowOfCells mine;
            if (lane_ < kCellRows) mine = search_.rowAbout(cell, lane_);
            for (uint32_t which = 0; which < kCellRows; ++which) {
                const uint32_t wrapped = __shfl_sync(kAll, mine.wrapped, which);
                visit(which, __shfl_sync(kAll, mine.first, which), __shfl_sync(kAll, mine.last, which), from,
                      to);
                if (wrapped > 0) visit(which, 0, wrapped, from, to);
            }
        }
        runApart();
    }
    /// Those among the ones set apart alone.
    __device__ void runApart() {
        visit(kCellRows, search_.members(), search_.allMembers(), 0, count_);
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

    __device__ void visit(uint32_t which, uint32_t first, uint32_t last, uint32_t from, uint32_t to) {
        for (uint32_t base = first; base < last; base += 32) {
            const uint32_t at = base + lane_;
            const Vec4<Real> ball = search_.member.ball[at < last ? at : base];
            for (uint32_t g = from; g < to; ++g) {
                const bool passes = at < last && ballsTouch(own_[g].ball, ball);
                const unsigned chosen = __ballot_sync(kAll, passes);
                if (passes) memory_.queue[queued_ + __popc(chosen & ((1u << lane_) - 1))] = {at, g, which};
                queued_ += __popc(chosen);
                if (queued_ > WarpMemory<kGroup, Real>::kQueue - 32) drain();
            }
        }
    }
    __device__ void drain() {
        __syncwarp();
        for (uint32_t k = lane_; k < queued_; k += 32) lookAt(memory_.queue[k]);
        queued_ = 0;
        __syncwarp();
    }
    __device__ void lookAt(const typename WarpMemory<kGroup, Real>::Candidate& candidate) const {
        const uint32_t at = candidate.at, g = candidate.group, j = search_.member.id[at];
        const GridMember<Real>& own = own_[g];
        if (!isInRow(own, at, candidate.which) || !search_.meetsMember(own, at) || hasRecord(g, j)) return;
        append(g, j);
        if (candidate.which == kCellRows && !isApart()) drafts_.putApart(j, at - search_.members(), own.id);
    }
    /// Row kCellRows: all those set apart.
    __device__ bool isInRow(const GridMember<Real>& own, uint32_t at, uint32_t which) const {
        const GridCell centre = cellOf(own.key), cell = cellOf(search_.member.key[at]);
        return which == kCellRows || (cell.y == centre.y + static_cast<int32_t>(which % 3) - 1 &&
                                      cell.z == centre.z + static_cast<int32_t>(which / 3) - 1);
    }
    __device__ bool isApart() const { return first_ >= search_.members(); }
    __device__ bool hasRecord(uint32_t g, uint32_t j) const {
        const uint32_t count = memory_.record_count[g];
        if (count > kRecordsAtHand) return search_.hasBondRecord(own_[g].id, j);
        bool found = false;
        for (uint32_t k = 0; k < count; ++k) found = found || memory_.records[g][k] == j;
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
    apart ? own.runApart() : own.run();
    own.finish(projectiles);
}

}  // namespace demolish
