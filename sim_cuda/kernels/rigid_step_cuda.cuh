// Contact steps on the GPU: some threads gather what a particle may touch; a warp moves a small fragment, a
// block a large one.
#pragma once
#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/kernels/rigid_touches.h"
#include "sim_cuda/kernels/substep_cuda.cuh"

namespace demolish {

/// What comes of the touches of an active particle.
template <bool kLedger, class Real>
class TouchLoads {
  public:
    __device__ TouchLoads(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                          const RigidWork& work, const OwnParticle<Real>& own, RigidLoad<Real>& load)
        : arrays_(arrays), params_(params), work_(work), own_(own), load_(load) {}

    /// Of an entry of RigidTouches.
    __device__ __forceinline__ Wrench<Real> of(uint32_t entry) {
        return entry % 2 == 0 ? countedBondSlot<kLedger>(arrays_, params_, own_, entry / 2, load_)
                              : countedContactSlot<kLedger>(arrays_, params_, own_, entry / 2, load_);
    }
    /// Of all in one of the sums.
    __device__ Wrench<Real> ofRows(const RowEnds& ends, uint32_t sum) {
        Wrench<Real> total;
        const uint32_t label = work_.label[own_.id];
        for (uint32_t slot = ends.first_bond + sum; slot < ends.last_bond; slot += kPartials)
            if (joinsFragments(arrays_.link[slot], work_.label, label)) add(total, of(2 * slot));
        for (uint32_t slot = ends.first_contact + sum; slot < ends.last_contact; slot += kPartials)
            if (work_.label[arrays_.neighbour[slot]] != label) add(total, of(2 * slot + 1));
        return total;
    }

  private:
    const SubstepArrays<Real>& arrays_;
    const StepParams<Real>& params_;
    const RigidWork& work_;
    const OwnParticle<Real>& own_;
    RigidLoad<Real>& load_;
};

/// T threads a particle, T / kPartials a sum: those take its touches in turn, so that a round of all of them
/// is added in the order of the list. Both kernels start while the one before still runs, as substepKernel
/// does.
template <uint32_t T, bool kLedger, class Real>
__global__ void __launch_bounds__(kSubstepBlock)
    rigidLoadKernel(const SubstepArrays<Real> arrays, const StepParams<Real> params, const RigidWork work,
                    const RigidTouches touches, const Span<RigidLoad<Real>> load) {
    constexpr uint32_t kParticles = kSubstepBlock / T, kTurns = T / kPartials;
    letNextStart();
    const uint32_t active = work.counts[kActiveCount];
    if (blockIdx.x > 0 && blockIdx.x * kParticles >= active) return;
    const uint32_t place = blockIdx.x * kParticles + threadIdx.x / T, lane = threadIdx.x % T;
    const uint32_t sum = place * kPartials + lane % kPartials, turn = lane / kPartials;
    const bool present = place < active;
    const uint32_t id = work.active[present ? place : active > 0 ? active - 1 : 0];
    const uint32_t count = present ? touches.count[sum] : 0;
    const bool listed = count != kTooManyTouches;
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    RigidLoad<Real> out;
    TouchLoads<kLedger, Real> loads(arrays, params, work, own, out);
    LanePartials<T, Real> sums;
    for (uint32_t k = turn; __any_sync(0xffffffffu, listed ? k < count : k == 0); k += kTurns) {
        Wrench<Real> term;
        if (listed && k < count) term = loads.of(touches.slot[size_t{sum} * kMostTouches + k]);
        if (!listed && k == 0) term = loads.ofRows(rowEnds(arrays, id, present), lane);
        __syncwarp();
        sums.template add<0>(term);
    }
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
                   __shfl_xor_sync(0xffffffffu, sums.touching, step)});
    return sums;
}

template <bool kLedger, class Real>
__device__ void moveSmall(const StepRigid<kLedger, Real>& step, uint32_t entry, uint32_t lane) {
    static_assert(kShortRigidRow == 2 * kWarp);
    const uint32_t lanes = laneCount(step.places(entry));
    RigidBody body = step.work.body[step.work.fragment[entry]];
    RigidSums sums;
    if (lane < lanes) sums = step.gather(body, entry, lane, lanes);
    if (lanes > kWarp) add(sums, step.gather(body, entry, lane + kWarp, lanes));
    step.move(body, warpTotal(sums, lanes < kWarp ? lanes : kWarp));
    // Lanes beyond the tree have no total.
    if (lane == 0) step.keep(body, entry);
    if (lane < lanes) step.place(body, entry, lane, lanes < kWarp ? lanes : kWarp);
}

template <bool kLedger, class Real>
__device__ void moveLarge(const StepRigid<kLedger, Real>& step, uint32_t entry) {
    __shared__ alignas(16) unsigned char sums_memory[kRigidLanes * sizeof(RigidSums)];
    __shared__ alignas(16) unsigned char body_memory[sizeof(RigidBody)];
    auto* sums = reinterpret_cast<RigidSums*>(sums_memory);
    auto& moved = *reinterpret_cast<RigidBody*>(body_memory);
    const uint32_t lane = threadIdx.x, lanes = laneCount(step.places(entry));
    RigidBody body = step.work.body[step.work.fragment[entry]];
    sums[lane] = lane < lanes ? step.gather(body, entry, lane, lanes) : RigidSums{};
    for (uint32_t width = lanes / 2; width >= kWarp; width /= 2) {
        __syncthreads();
        if (lane < width) add(sums[lane], sums[lane + width]);
    }
    if (lane < kWarp) {
        step.move(body, warpTotal(sums[lane], kWarp));
        if (lane == 0) {
            step.keep(body, entry);
            moved = body;
        }
    }
    __syncthreads();
    step.place(moved, entry, lane, kRigidLanes);
}

/// The first large_blocks blocks move one large fragment each, the warps of the others one small one.
template <bool kLedger, class Real>
__global__ void __launch_bounds__(kRigidLanes)
    rigidStepKernel(const StepRigid<kLedger, Real> step, uint32_t large_blocks) {
    letNextStart();
    awaitPrevious();
    if (blockIdx.x < large_blocks) {
        if (blockIdx.x < step.work.counts[kLargeCount]) moveLarge(step, step.work.large[blockIdx.x]);
        return;
    }
    const uint32_t entry = ((blockIdx.x - large_blocks) * kRigidLanes + threadIdx.x) / kWarp;
    if (entry < step.work.counts[kFragmentCount] && step.places(entry) <= kShortRigidRow)
        moveSmall(step, entry, threadIdx.x % kWarp);
}

}  // namespace demolish
