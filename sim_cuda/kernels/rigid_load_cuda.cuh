// SPDX-License-Identifier: Apache-2.0
// What acts on the particles of rigid fragments, on the GPU: T threads go through the rows of a particle.
#pragma once
#include <cuda_pipeline.h>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/kernels/rigid_load.h"
#include "sim_cuda/kernels/substep_cuda.cuh"

namespace demolish {

/// The loads of a contact step.
template <class Real>
struct RigidGather {
    SubstepArrays<Real> arrays;
    StepParams<Real> params;
    RigidWork work;
    Span<RigidLoadsOf<Real>> loads;  ///< by the place in RigidWork::active
};

/// Blocks that so many particles take, with T threads for each.
template <uint32_t T>
DEM_FN uint32_t gatherBlocks(uint32_t active) {
    constexpr uint32_t kParticles = kSubstepBlock / T;
    return (active + kParticles - 1) / kParticles;
}

/// Up to so many particles, which a GPU holds all at once, rows and colliders are seen to side by side;
/// beyond them by a kernel each, since rows need fewer registers. Threads that go through the rows of a
/// particle.
inline constexpr uint32_t kFewActive = 8192, kThreadsOfFew = 16, kThreadsOfMany = 8;

/// What the rows give; `block`: of those that do this.
template <uint32_t T, bool kLedger, class Real>
__device__ __forceinline__ void gatherRowsOf(const RigidGather<Real>& gather, uint32_t block,
                                             uint32_t count) {
    const SubstepArrays<Real>& arrays = gather.arrays;
    const StepParams<Real>& params = gather.params;
    const RigidWork& work = gather.work;
    const uint32_t place = block * (kSubstepBlock / T) + threadIdx.x / T, lane = threadIdx.x % T;
    const bool present = place < count;
    const uint32_t id = work.active[present ? place : count - 1];
    const RowEnds ends = rowEnds(arrays, id, present);
    const uint32_t label = work.label[id];
    const auto bond_end = [&](uint32_t slot) {
        // Past the first cache, which would keep a state of the pair that is changing meanwhile.
        const uint32_t j = __ldcg(&arrays.link[slot].link) & kLinkIdMask;
        return OtherFragment{j, work.label[j]};
    };
    const auto fragment = [&](uint32_t slot) { return contactFragment(arrays, work.label, slot); };
    RowCursor<T, decltype(bond_end)> bonds(ends.first_bond, ends.last_bond, lane, bond_end, bond_end);
    RowCursor<T, decltype(fragment)> contacts(ends.first_contact, ends.last_contact, lane, fragment,
                                              fragment);
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    LanePartial<T, Real> sum;
    RigidLoad<Real> out;
    gatherRow<T>(bonds, sum, [&](uint32_t slot, const OtherFragment& other) {
        return countedBondSlot<kLedger>(arrays, params, label, own, slot, other, out);
    });
    gatherRow<T>(contacts, sum, [&](uint32_t slot, const OtherFragment& other) {
        return countedContactSlot<kLedger>(arrays, params, label, own, slot, other, out);
    });
    __syncwarp();
    out.push.wrench = sum.total();
    for (uint32_t step = T / 2; step > 0; step /= 2)
        out.push.touching += __shfl_down_sync(0xffffffffu, out.push.touching, step, T);
    if constexpr (kLedger) sumTally<T>(out.tally);
    if (present && lane == 0) gather.loads[place].template keepRows<kLedger>(out);
}

/// Corners of a particle that are fetched at once: as many as cells have. Threads that do so, of which one
/// does the rest.
inline constexpr uint32_t kFetchedCorners = kMostCorners, kFetching = 4;
/// Of the particle that this thread shares with others.
template <class Real>
__device__ __forceinline__ Vec4<Real>* cornerMemory() {
    constexpr uint32_t kCorners = kSubstepBlock / kFetching * kFetchedCorners;
    __shared__ alignas(16) unsigned char memory[kCorners * sizeof(Vec4<Real>)];
    return reinterpret_cast<Vec4<Real>*>(memory) + threadIdx.x / kFetching * kFetchedCorners;
}
/// In nearer memory. All threads of the particle take part.
template <class Real>
__device__ __forceinline__ OwnCorners<Real> fetched(OwnCorners<Real> corners, uint32_t lane) {
    const auto count = static_cast<uint32_t>(corners.from_seed.size());
    Vec4<Real>* near = cornerMemory<Real>();
    if (count <= kFetchedCorners) {
        for (uint32_t k = lane; k < count; k += kFetching)
            __pipeline_memcpy_async(&near[k], &corners.from_seed[k], sizeof(Vec4<Real>));
        corners.from_seed.data = near;
    }
    __pipeline_commit();
    __pipeline_wait_prior(0);
    __syncwarp();
    return corners;
}

/// What colliders give. Their part needs no other particle.
template <bool kLedger, class Real, class Colliders>
__device__ __forceinline__ void gatherCollidersOf(const RigidGather<Real>& gather, const Colliders& colliders,
                                                  uint32_t block, uint32_t count) {
    const uint32_t place = block * (kSubstepBlock / kFetching) + threadIdx.x / kFetching;
    const uint32_t id = gather.work.active[place < count ? place : count - 1], lane = threadIdx.x % kFetching;
    const OwnCorners<Real> corners = fetched(cornersOf(gather.arrays.corners, id), lane);
    awaitPrevious();
    constexpr bool kOnlyPlanes = std::is_same_v<Colliders, PlanesOnly<Real>>;
    using Lanes = LaneGroup<kOnlyPlanes || kLedger ? 1 : kFetching>;
    if (place >= count || lane >= Lanes::kCount) return;
    const Lanes lanes{lane};
    const OwnParticle<Real> own = loadOwn(gather.arrays, id);
    const RigidLoad<Real> load = collidersLoad<kLedger>(gather.arrays, gather.params, colliders, gather.work,
                                                        own, corners, LooksItself<Lanes>{lanes});
    if (lanes.leads()) gather.loads[place].template keepColliders<kLedger>(load);
}

/// Both side by side: the first `collider_blocks` see to colliders, the others to rows. The first block waits
/// for the step before in any case, so that the next one may rely on it; so do the other two kernels. With a
/// block more on a multiprocessor what a corner needs does not fit into registers.
template <bool kLedger, bool kOnlyPlanes, class Real>
__global__ void __launch_bounds__(kSubstepBlock, 4)
    rigidLoadKernel(const __grid_constant__ RigidGather<Real> gather, uint32_t collider_blocks) {
    letNextStart();
    const auto& colliders = seenColliders<kOnlyPlanes>(gather.params.colliders);
    const uint32_t block = blockIdx.x, count = gather.work.counts[kActiveCount];
    if (block == 0 && count == 0) awaitPrevious();
    if (block < collider_blocks) {
        if (block < gatherBlocks<kFetching>(count))
            gatherCollidersOf<kLedger>(gather, colliders, block, count);
    } else if (block - collider_blocks < gatherBlocks<kThreadsOfFew>(count)) {
        gatherRowsOf<kThreadsOfFew, kLedger>(gather, block - collider_blocks, count);
    }
}
/// Rows alone.
template <bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock, 6)
    rigidRowsKernel(const __grid_constant__ RigidGather<Real> gather) {
    letNextStart();
    const uint32_t block = blockIdx.x, count = gather.work.counts[kActiveCount];
    if (block == 0 && count == 0) awaitPrevious();
    if (block < gatherBlocks<kThreadsOfMany>(count))
        gatherRowsOf<kThreadsOfMany, kLedger>(gather, block, count);
}
/// Colliders alone.
template <bool kLedger, bool kOnlyPlanes, class Real>
__global__ void __launch_bounds__(kSubstepBlock, 4)
    rigidCollidersKernel(const __grid_constant__ RigidGather<Real> gather) {
    letNextStart();
    const auto& colliders = seenColliders<kOnlyPlanes>(gather.params.colliders);
    const uint32_t block = blockIdx.x, count = gather.work.counts[kActiveCount];
    if (block == 0 && count == 0) awaitPrevious();
    if (block < gatherBlocks<kFetching>(count)) gatherCollidersOf<kLedger>(gather, colliders, block, count);
}

}  // namespace demolish
