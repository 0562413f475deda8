// SPDX-License-Identifier: Apache-2.0
// What acts on the particles of rigid fragments, on the GPU: T threads go through the rows of a particle, and
// other blocks may do a substep meanwhile.
#pragma once
#include "sim_cuda/kernels/rigid_load.h"
#include "sim_cuda/kernels/substep_cuda.cuh"

namespace demolish {

/// The loads of a contact step.
template <class Real>
struct RigidGather {
    SubstepArrays<Real> arrays;
    StepParams<Real> params;
    RigidWork work;
    Span<RigidLoad<Real>> load;
};

/// Blocks that it takes.
template <uint32_t T>
uint32_t gatherBlocks(uint32_t active) {
    constexpr uint32_t kParticles = kSubstepBlock / T;
    return (active + kParticles - 1) / kParticles;
}

/// T threads a particle. The first block waits for the step before in any case, so that the next one may rely
/// on it.
template <uint32_t T, bool kLedger, class Real>
__device__ __forceinline__ void gatherRigidLoads(const RigidGather<Real>& gather, uint32_t block) {
    constexpr uint32_t kParticles = kSubstepBlock / T;
    const SubstepArrays<Real>& arrays = gather.arrays;
    const StepParams<Real>& params = gather.params;
    const RigidWork& work = gather.work;
    const uint32_t count = work.counts[kActiveCount];
    if (block > 0 && block * kParticles >= count) return;
    const uint32_t place = block * kParticles + threadIdx.x / T, lane = threadIdx.x % T;
    const bool present = place < count;
    const uint32_t id = work.active[present ? place : count > 0 ? count - 1 : 0];
    const RowEnds ends = rowEnds(arrays, id, present);
    const uint32_t label = work.label[id];
    const KeptTouches kept = work.carries(id) ? KeptTouches::kLeftToSubstep : KeptTouches::kCountedHere;
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    LanePartials<T, Real> sums;
    RigidLoad<Real> out;
    const auto link_end = [&](uint32_t slot) { return linkEnd(arrays, slot); };
    const auto fragment = [&](uint32_t slot) { return contactFragment(arrays, work.label, slot); };
    RowCursor<T, decltype(link_end)> bonds(ends.first_bond, ends.last_bond, lane, link_end, link_end);
    RowCursor<T, decltype(fragment)> contacts(ends.first_contact, ends.last_contact, lane, fragment,
                                              fragment);
    gatherRow<T>(bonds, sums, [&](uint32_t slot, const LinkEnd& end) {
        return countedBondSlot<kLedger>(arrays, params, work.label, own, slot, end, kept, out);
    });
    gatherRow<T>(contacts, sums, [&](uint32_t slot, const ContactFragment& other) {
        return countedContactSlot<kLedger>(arrays, params, label, own, slot, other, kept, out);
    });
    __syncwarp();
    out.wrench = sums.total();
    for (uint32_t step = T / 2; step > 0; step /= 2)
        out.touching += __shfl_down_sync(0xffffffffu, out.touching, step, T);
    if constexpr (kLedger) sumTally<T>(out.tally);
    if (!present || lane != 0) return;
    addPlanes<kLedger>(arrays, params, work, own, out);
    RigidLoad<Real>& load = gather.load[place];
    if constexpr (kLedger) load.tally = out.tally;
    load.wrench = out.wrench;
    load.touching = out.touching;
}

template <uint32_t T, bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock) rigidLoadKernel(const RigidGather<Real> gather) {
    letNextStart();
    gatherRigidLoads<T, kLedger>(gather, blockIdx.x);
}

/// For a particle that substeps carry: how many of its contacts keepsTouching() is true of. T threads; the
/// sum is in the first.
template <uint32_t T, class Real>
struct CarriedTouches {
    const RigidGather<Real>& gather;

    __device__ __forceinline__ uint32_t operator()(const OwnParticle<Real>& own, const RowEnds& ends,
                                                   uint32_t lane) const {
        if (!__any_sync(0xffffffffu, own.isCarried())) return 0;
        const SubstepArrays<Real>& arrays = gather.arrays;
        uint32_t touching = 0;
        if (own.isCarried()) {
            for (uint32_t slot = ends.first_bond + lane; slot < ends.last_bond; slot += T)
                touching += touches(own.id, linkedParticle(arrays.link[slot]), arrays.bond_spring[slot]);
            for (uint32_t slot = ends.first_contact + lane; slot < ends.last_contact; slot += T)
                touching += touches(own.id, arrays.neighbour[slot], arrays.contact_spring[slot]);
        }
        for (uint32_t step = T / 2; step > 0; step /= 2)
            touching += __shfl_down_sync(0xffffffffu, touching, step, T);
        return touching;
    }

  private:
    __device__ __forceinline__ uint32_t touches(uint32_t i, uint32_t j, const Vec4<Real>& spring) const {
        const Span<const uint32_t>& label = gather.work.label;
        return keepsTouching(asConstants(gather.arrays.constants[j]), spring) && label[i] != label[j] ? 1 : 0;
    }
};

/// Particles up to which sixteen threads go through the rows of one, beside a substep or not.
inline constexpr uint32_t kFewActive = 8192;

/// Threads that share a particle of a rigid fragment while a substep is done beside it.
constexpr uint32_t threadsBeside(uint32_t active) {
    return active <= kFewActive ? 16 : 8;
}

/// The first substep after a contact step, by T threads a particle, and the loads of the next one, by G, side
/// by side: the one writes the instant of the state that the other does not read.
template <uint32_t T, uint32_t G, bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock, kLedger ? 4 : blocksAtOnce(T))
    substepBesideLoadsKernel(const SubstepArrays<Real> arrays, const StepParams<Real> params,
                             const RigidGather<Real> gather, uint32_t gather_blocks) {
    letNextStart();
    const uint32_t block = blockIdx.x;
    if (block >= kMaxProjectiles && block < kMaxProjectiles + gather_blocks)
        return gatherRigidLoads<G, kLedger>(gather, block - kMaxProjectiles);
    const CarriedTouches<T, Real> counts{gather};
    substepBlock<T, kLedger>(arrays, params, block < kMaxProjectiles ? block : block - gather_blocks, counts);
}

}  // namespace demolish
