// SPDX-License-Identifier: Apache-2.0
// Rigid fragments moved on the GPU: a warp moves a small one, a block a large one.
#pragma once
#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/kernels/substep_cuda.cuh"

namespace demolish {

inline constexpr uint32_t kWarp = 32;

__device__ __forceinline__ Vec3<double> exchanged(const Vec3<double>& value, uint32_t with) {
    constexpr unsigned kAll = 0xffffffffu;
    return {__shfl_xor_sync(kAll, value.x, with), __shfl_xor_sync(kAll, value.y, with),
            __shfl_xor_sync(kAll, value.z, with)};
}

/// The tree over the first `lanes` lanes of a warp, in every lane: a + b and b + a are the same bits.
__device__ __forceinline__ RigidSums warpTotal(RigidSums sums, uint32_t lanes) {
    for (uint32_t step = lanes / 2; step > 0; step /= 2)
        add(sums, {exchanged(sums.force, step), exchanged(sums.torque, step),
                   __shfl_xor_sync(0xffffffffu, sums.touching, step),
                   __shfl_xor_sync(0xffffffffu, sums.standing, step),
                   __shfl_xor_sync(0xffffffffu, sums.coming, step)});
    return sums;
}

/// Reads what no step changes, then waits for the step before.
template <bool kLedger, class Real>
__device__ void moveSmall(const StepRigid<kLedger, Real>& step, const RigidRow& row, uint32_t lane) {
    static_assert(kShortRigidRow == 2 * kWarp);
    const uint32_t lanes = laneCount(row.places());
    const RigidSeat<Real> seat = step.seat(row, lane);
    awaitPrevious();
    RigidBody body = step.work.body[row.slot];
    RigidSums sums;
    if (lane < lanes) sums = step.gather(body, row, seat, lane, lanes);
    if (lanes > kWarp) add(sums, step.gather(body, row, step.seat(row, lane + kWarp), lane + kWarp, lanes));
    const double lost = step.move(body, warpTotal(sums, lanes < kWarp ? lanes : kWarp));
    // Lanes beyond the tree have no total.
    if (lane == 0) step.keep(body, row, lost);
    if (lane < lanes) step.place(body, row, seat, lane, lanes < kWarp ? lanes : kWarp);
}

template <bool kLedger, class Real>
__device__ void moveLarge(const StepRigid<kLedger, Real>& step, const RigidRow& row) {
    __shared__ alignas(16) unsigned char sums_memory[kRigidLanes * sizeof(RigidSums)];
    __shared__ alignas(16) unsigned char body_memory[sizeof(RigidBody)];
    auto* sums = reinterpret_cast<RigidSums*>(sums_memory);
    auto& moved = *reinterpret_cast<RigidBody*>(body_memory);
    const uint32_t lane = threadIdx.x, lanes = laneCount(row.places());
    const RigidSeat<Real> seat = step.seat(row, lane);
    awaitPrevious();
    RigidBody body = step.work.body[row.slot];
    sums[lane] = lane < lanes ? step.gather(body, row, seat, lane, lanes) : RigidSums{};
    for (uint32_t width = lanes / 2; width >= kWarp; width /= 2) {
        __syncthreads();
        if (lane < width) add(sums[lane], sums[lane + width]);
    }
    if (lane < kWarp) {
        const double lost = step.move(body, warpTotal(sums[lane], kWarp));
        if (lane == 0) {
            step.keep(body, row, lost);
            store(moved, body);
        }
    }
    __syncthreads();
    step.place(moved, row, seat, lane, kRigidLanes);
}

/// The first large_blocks blocks move one large fragment each, the warps of the others one small one. There
/// is a fragment, so that somebody waits for the step before and the next one may rely on it.
template <bool kLedger, class Real>
__global__ void __launch_bounds__(kRigidLanes, 2)
    rigidStepKernel(const StepRigid<kLedger, Real> step, uint32_t large_blocks) {
    letNextStart();
    const RigidWork& work = step.work;
    if (blockIdx.x < large_blocks) {
        if (blockIdx.x < work.counts[kLargeCount]) moveLarge(step, step.row(work.large[blockIdx.x]));
        return;
    }
    const uint32_t entry = ((blockIdx.x - large_blocks) * kRigidLanes + threadIdx.x) / kWarp;
    if (entry >= work.counts[kFragmentCount]) return;
    const RigidRow row = step.row(entry);
    if (row.places() <= kShortRigidRow) moveSmall(step, row, threadIdx.x % kWarp);
}

}  // namespace demolish
