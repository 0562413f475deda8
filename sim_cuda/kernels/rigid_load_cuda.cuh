// SPDX-License-Identifier: Apache-2.0
// What acts on the particles of rigid fragments, on the GPU: T threads go through the rows of a particle.
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

/// Particles up to which sixteen threads go through the rows of one, beyond them eight.
inline constexpr uint32_t kFewActive = 8192;

/// T threads a particle. The first block waits for the step before in any case, so that the next one may rely
/// on it. With six blocks a multiprocessor instead of five, what
/// a corner needs does not fit into registers.
template <uint32_t T, bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock, 5) rigidLoadKernel(const RigidGather<Real> gather) {
    constexpr uint32_t kParticles = kSubstepBlock / T;
    letNextStart();
    const uint32_t block = blockIdx.x;
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
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    LanePartial<T, Real> sum;
    RigidLoad<Real> out;
    const auto link_end = [&](uint32_t slot) { return linkEnd(arrays, slot); };
    const auto fragment = [&](uint32_t slot) { return contactFragment(arrays, work.label, slot); };
    RowCursor<T, decltype(link_end)> bonds(ends.first_bond, ends.last_bond, lane, link_end, link_end);
    RowCursor<T, decltype(fragment)> contacts(ends.first_contact, ends.last_contact, lane, fragment,
                                              fragment);
    gatherRow<T>(bonds, sum, [&](uint32_t slot, const LinkEnd& end) {
        return countedBondSlot<kLedger>(arrays, params, work.label, own, slot, end, out);
    });
    gatherRow<T>(contacts, sum, [&](uint32_t slot, const ContactFragment& other) {
        return countedContactSlot<kLedger>(arrays, params, label, own, slot, other, out);
    });
    __syncwarp();
    out.wrench = sum.total();
    for (uint32_t step = T / 2; step > 0; step /= 2)
        out.touching += __shfl_down_sync(0xffffffffu, out.touching, step, T);
    if constexpr (kLedger) sumTally<T>(out.tally);
    if (!present || lane != 0) return;
    addColliders<kLedger>(arrays, params, work, own, out);
    RigidLoad<Real>& load = gather.load[place];
    if constexpr (kLedger) load.tally = out.tally;
    load.wrench = out.wrench;
    load.touching = out.touching;
    load.coming = out.coming;
}

}  // namespace demolish
