// Contact steps on the GPU: kLoadThreads threads gather the row of a particle, a block moves a fragment.
#pragma once
#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/kernels/substep_cuda.cuh"

namespace demolish {

inline constexpr uint32_t kLoadThreads = 8;

template <bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock)
    rigidLoadKernel(const SubstepArrays<Real> arrays, const StepParams<Real> params, const RigidWork work,
                    const Span<RigidLoad<Real>> load) {
    constexpr uint32_t T = kLoadThreads, kParticles = kSubstepBlock / T;
    const uint32_t count = work.counts[kActiveCount];
    if (blockIdx.x * kParticles >= count) return;
    const uint32_t place = blockIdx.x * kParticles + threadIdx.x / T, lane = threadIdx.x % T;
    const bool present = place < count;
    const OwnParticle<Real> own = loadOwn(arrays, work.active[present ? place : count - 1]);
    LanePartials<T, Real> sums;
    RigidLoad<Real> out;
    const auto row = [&](const Span<const uint32_t>& rows, uint32_t end) {
        return present ? rows[own.id + end] : 0u;
    };
    gatherRow<T>(row(arrays.bond_row, 0), row(arrays.bond_row, 1), lane, sums, [&](uint32_t slot) {
        return countedBondSlot<kLedger>(arrays, params, work.label, own, slot, out);
    });
    gatherRow<T>(row(arrays.contact_row, 0), row(arrays.contact_row, 1), lane, sums,
                 [&](uint32_t slot) { return countedContactSlot<kLedger>(arrays, params, own, slot, out); });
    __syncwarp();
    out.wrench = sums.total();
    for (uint32_t step = T / 2; step > 0; step /= 2)
        out.touching += __shfl_down_sync(0xffffffffu, out.touching, step, T);
    if constexpr (kLedger) sumTally<T>(out.tally);
    if (!present || lane != 0) return;
    addPlanes<kLedger>(arrays, params, own, out);
    if constexpr (kLedger) load[place].tally = out.tally;
    load[place].wrench = out.wrench;
    load[place].touching = out.touching;
}

template <bool kLedger, class Real>
__global__ void __launch_bounds__(kRigidLanes) rigidStepKernel(const StepRigid<kLedger, Real> step) {
    __shared__ alignas(16) unsigned char sums_memory[kRigidLanes * sizeof(RigidSums)];
    __shared__ alignas(16) unsigned char body_memory[sizeof(RigidBody)];
    auto* lanes = reinterpret_cast<RigidSums*>(sums_memory);
    auto& body = *reinterpret_cast<RigidBody*>(body_memory);
    const uint32_t entry = blockIdx.x, lane = threadIdx.x;
    if (entry >= step.work.counts[kFragmentCount]) return;
    const RigidBody before = step.work.body[step.work.fragment[entry]];
    lanes[lane] = step.gather(before, entry, lane);
    for (uint32_t width = kRigidLanes / 2; width > 0; width /= 2) {
        __syncthreads();
        if (lane < width) add(lanes[lane], lanes[lane + width]);
    }
    if (lane == 0) {
        body = before;
        step.move(body, entry, lanes[0]);
    }
    __syncthreads();
    step.place(body, entry, lane);
}

}  // namespace demolish
