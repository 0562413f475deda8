// SPDX-License-Identifier: Apache-2.0
// One substep on the GPU, one kernel: T threads gather a particle's slots and agree on the sum in the fixed
// order; another thread, which has found out meanwhile what colliders give, moves it, or the first of them.
// Whatever T is, slot k of a row ends in partial sum k mod kPartials and is added in slot order, so that
// every T, and the CPU, give the same bits (frame facts 3).
#pragma once
#include "sim_cuda/backend/cuda_chained_launch.cuh"
#include "sim_cuda/kernels/gather_rows_cuda.cuh"
#include "sim_cuda/kernels/move_particle.h"
#include "sim_cuda/kernels/near_shapes_cuda.cuh"

namespace demolish {

/// Breaks it when its time has come.
template <bool kLedger, class Real>
__device__ __forceinline__ Wrench<Real> solidBondSlot(const SubstepArrays<Real>& arrays,
                                                      const StepParams<Real>& params,
                                                      const OwnParticle<Real>& own, const BodyLaw<Real>& law,
                                                      const FormerBond<Real>& read, Tally<Real>& tally) {
    const uint32_t j = linkedParticle(read.link);
    const BondConstants<Real> bond = bondConstants(read.rest, read.link.grade, law);
    const PairMotion<Real> pair = pairMotion(own.state, read.other);
    const BondEffect<Real> effect = bondEffect(bond, pair);
    const bool breaks = params.breaking != 0 && bondBreaks(effect.severity, effect.limit);
    if (breaks) arrays.link[read.slot].link = linkWord(j, PairState::kBroken);
    if constexpr (kLedger) {
        const BondEffect<Real> damping = bondDamping(bond, pair);
        add(tally.damping, {damping.force, damping.torque_i});
        if (breaks) tally.addBreak(bondRelease(bond, pair), own.id < j);
    }
    return {effect.force, effect.torque_i};
}

/// A slot that is still a solid bond, which breaks when its time has come, or one that no longer is. Where
/// threads read ahead and some bonds of a warp are broken, what either kind needs is asked for before any of
/// it is used.
template <uint32_t T, bool kLedger, class Real>
__device__ __forceinline__ Wrench<Real> bondSlot(const SubstepArrays<Real>& arrays,
                                                 const StepParams<Real>& params, const OwnParticle<Real>& own,
                                                 const BodyLaw<Real>& law, uint32_t slot, const LinkEnd& end,
                                                 Tally<Real>& tally) {
    const uint32_t j = end.id;
    const BondLink link = end.link;
    const bool solid = isBonded(link);
    if (!kReadsAhead<T> && !solid) return formerBondSlot<kLedger>(arrays, params, own, slot, end, tally);
    FormerBond<Real> read{slot, link, loadState(arrays.in, j), {}, arrays.rest[slot], {}};
    if (kReadsAhead<T> && __any_sync(__activemask(), !solid)) {
        read.constants = arrays.constants[solid ? own.id : j];
        read.spring = arrays.bond_spring[solid ? 0 : slot];
        if (!solid)
            return isApart(own, read.other.position, read.constants, link, read.spring, params)
                       ? Wrench<Real>{}
                       : touchingFormerBond<kLedger>(arrays, params, own, read, tally);
    }
    return own.isCarried() ? Wrench<Real>{} : solidBondSlot<kLedger>(arrays, params, own, law, read, tally);
}

/// Moves apart: a warp more in each block moves what the others have gathered for; a thread each finds out
/// meanwhile what colliders give. Of so many particles that a GPU has enough to do in any case, the first of
/// a particle's threads moves it.
constexpr uint32_t substepThreads(bool moves_apart) {
    return kSubstepBlock + (moves_apart ? 32 : 0);
}
/// Corners on shapes are shared (NearShapes). On planes they are too little work for that, and the ledger's
/// kernels need not be fast: there the thread that moves a particle looks at them by itself.
constexpr bool looksTogether(bool only_planes, bool ledger) {
    return !only_planes && !ledger;
}
/// The thread that moves a particle, as far as it comes before the others have gathered.
template <bool kLedger, Movable kMovable, class Real>
struct MovingThread {
    OwnParticle<Real> own;
    Wrench<Real> push;  ///< of colliders
    Tally<Real> tally;
    uint32_t near = 0;  ///< bit c: it may touch collider c; or 1: it may touch any

    template <class Colliders>
    __device__ __forceinline__ void load(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                         const Colliders& colliders, uint32_t id) {
        own = loadOwn(arrays, id);
        near = isNearColliders<StepKind::kSubstep>(params, colliders, own) ? 1 : 0;
    }
    /// All threads of the warp that moves. Meshes that bounds call near are looked at at once where they are
    /// few enough for that; asking a node of their grids first comes before everything else there.
    __device__ __forceinline__ void loadForList(const SubstepArrays<Real>& arrays,
                                                const StepParams<Real>& params,
                                                const ColliderSet<Real>& colliders, uint32_t id, bool present,
                                                uint32_t few) {
        if (present) {
            own = loadOwn(arrays, id);
            near = collidersNear(params, colliders, own);
        }
        const uint32_t on_shapes = __ballot_sync(0xffffffffu, withoutPlanes(colliders, near) != 0);
        if (static_cast<uint32_t>(__popc(on_shapes)) > few)
            near = withoutFarMeshes(params, colliders, own, near);
    }
    template <class Colliders, class Source>
    __device__ __forceinline__ void meetColliders(const SubstepArrays<Real>& arrays,
                                                  const StepParams<Real>& params, const Colliders& colliders,
                                                  const Source& source) {
        if (near != 0) push = collidersPush<kLedger>(arrays, params, colliders, own, tally, source);
    }
    /// From the rows: what they give, and what is booked with it.
    __device__ __forceinline__ void finish(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                           const Wrench<Real>& gathered, const Tally<Real>& booked) {
        Wrench<Real> load = gathered;
        tally += booked;
        if (near != 0) add(load, push);
        moveParticle<kLedger, kMovable>(arrays, params, own, load, tally);
    }
};

/// What one of kLongPartials threads gathers of a long row.
template <bool kLedger, class Real>
__device__ __forceinline__ Wrench<Real> longRowPart(const SubstepArrays<Real>& arrays,
                                                    const StepParams<Real>& params,
                                                    const OwnParticle<Real>& own, uint32_t lane,
                                                    Tally<Real>& tally) {
    Wrench<Real> sum;
    const uint32_t first = arrays.contact_row[own.id], last = arrays.contact_row[own.id + 1];
    constexpr uint32_t kBatch = 4, kStep = kBatch * kLongPartials;
    for (uint32_t base = first + lane; base < last; base += kStep) {
        ContactEnd<Real> ends[kBatch];  // read together: of a long row hardly any touches
#pragma unroll
        for (uint32_t b = 0; b < kBatch; ++b)
            if (base + b * kLongPartials < last) ends[b] = contactEnd(arrays, base + b * kLongPartials);
#pragma unroll
        for (uint32_t b = 0; b < kBatch; ++b)
            if (base + b * kLongPartials < last)
                add(sum, contactSlot<kLedger>(arrays, params, own, base + b * kLongPartials, ends[b], tally));
    }
    return sum;
}
/// The sums of kLongPartials threads in the first place, by halves; all threads of the block take part.
template <bool kLedger, class Real>
__device__ __forceinline__ void foldSums(Wrench<Real>* sums, Tally<Real>* tallies) {
    for (uint32_t step = kLongPartials / 2; step > 0; step /= 2) {
        __syncthreads();
        if (threadIdx.x >= step) continue;
        add(sums[threadIdx.x], sums[threadIdx.x + step]);
        if constexpr (kLedger) tallies[threadIdx.x] += tallies[threadIdx.x + step];
    }
    __syncthreads();
}

/// A projectile: its row is long, so that a whole block gathers it into kLongPartials sums.
template <bool kMovesApart, bool kLedger, class Real, class Colliders>
__device__ void stepProjectile(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                               const Colliders& colliders, uint32_t i) {
    static_assert(kSubstepBlock == kLongPartials);
    __shared__ alignas(16) unsigned char sums_memory[kLongPartials * sizeof(Wrench<Real>)];
    __shared__ alignas(16) unsigned char tallies_memory[kLedger ? kLongPartials * sizeof(Tally<Real>) : 16];
    auto* sums = reinterpret_cast<Wrench<Real>*>(sums_memory);
    auto* tallies = reinterpret_cast<Tally<Real>*>(tallies_memory);
    const uint32_t lane = threadIdx.x;
    constexpr uint32_t kMover = kMovesApart ? kSubstepBlock : 0;
    MovingThread<kLedger, Movable::kAll, Real> mover;
    const auto meet = [&] {
        mover.load(arrays, params, colliders, i);
        mover.meetColliders(arrays, params, colliders, LooksAtSphere{});
    };
    if (lane < kSubstepBlock) {
        Tally<Real> tally;
        sums[lane] = longRowPart<kLedger>(arrays, params, loadOwn(arrays, i), lane, tally);
        if constexpr (kLedger) tallies[lane] = tally;
    } else if (lane == kMover) {
        meet();
    }
    if constexpr (!kMovesApart)
        if (lane == kMover) meet();
    foldSums<kLedger>(sums, tallies);
    if (lane == kMover) mover.finish(arrays, params, sums[0], kLedger ? tallies[0] : Tally<Real>{});
}

/// Blocks that a multiprocessor shall hold: where many threads share a particle there are few particles, and
/// registers are worth more than blocks; so they are where corners on shapes are shared.
constexpr int blocksAtOnce(uint32_t threads, bool moves_apart, bool only_planes) {
    if (!moves_apart) return 6;
    return threads >= 16 || !only_planes ? 3 : 4;
}

/// Places of the work list.
template <class Real>
__device__ __forceinline__ uint32_t workCount(const SubstepArrays<Real>& arrays,
                                              const StepParams<Real>& params) {
    return arrays.work.all() ? params.in_bodies : arrays.work.listed();
}
/// The particle at a place; beyond the list an old one, so that it is read together with the list's length.
template <class Real>
__device__ __forceinline__ uint32_t workAt(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                           uint32_t k) {
    const uint32_t last = params.in_bodies - 1, place = k < last ? k : last;
    return arrays.work.all() ? place : arrays.work.ids[place];
}

/// A particle that T threads share. The first of them leaves what they have gathered.
template <uint32_t T, bool kLedger, class Real, class Leave>
__device__ __forceinline__ void gatherParticle(const SubstepArrays<Real>& arrays,
                                               const StepParams<Real>& params, uint32_t id, bool present,
                                               const Leave& leave) {
    const uint32_t lane = threadIdx.x % T;
    const RowEnds ends = rowEnds(arrays, id, present);
    const BodyLaw<Real> law = arrays.body_laws[arrays.owner[id]];
    const FirstEnds first_ends = firstEnds<T>(arrays, ends, lane);
    awaitPrevious();
    const OwnParticle<Real> own = loadOwn(arrays, id);
    LanePartial<T, Real> sum;
    Tally<Real> tally;
    gatherRows<T>(
        arrays, ends, first_ends, lane, sum,
        [&](uint32_t slot, const LinkEnd& end) {
            return bondSlot<T, kLedger>(arrays, params, own, law, slot, end, tally);
        },
        [&](uint32_t slot, const ContactEnd<Real>& end) {
            return contactSlot<kLedger>(arrays, params, own, slot, end, tally);
        });
    __syncwarp();
    const Wrench<Real> load = sum.total();
    if constexpr (kLedger) sumTally<T>(tally);
    if (lane == 0) leave(load, tally);
}

/// What the threads of a block leave each other.
template <uint32_t kParticles, bool kLedger, bool kTogether, class Real>
struct BlockMemory {
    Wrench<Real> sums[kParticles];
    Tally<Real> tallies[kLedger ? kParticles : 1];
    NearShapes<kTogether ? kParticles : 1, Real> near;
};

/// The particles of a block from place `first` of the work list on, moved by a warp of their own.
template <uint32_t T, bool kLedger, bool kOnlyPlanes, class Real, class Colliders>
__device__ __forceinline__ void stepApart(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                          const Colliders& colliders, uint32_t first) {
    constexpr uint32_t kParticles = kSubstepBlock / T;
    constexpr bool kTogether = looksTogether(kOnlyPlanes, kLedger);
    constexpr uint32_t kMeanwhile = lookedAtMeanwhile(T);
    using Memory = BlockMemory<kParticles, kLedger, kTogether, Real>;
    __shared__ alignas(16) unsigned char memory[sizeof(Memory)];
    auto& shared = *reinterpret_cast<Memory*>(memory);
    const bool moves = threadIdx.x >= kSubstepBlock;
    const uint32_t mover_thread = threadIdx.x - kSubstepBlock;
    const uint32_t place = moves ? mover_thread : threadIdx.x / T;
    const uint32_t id = workAt(arrays, params, first + place), count = workCount(arrays, params);
    if (first >= count) return;
    const bool present = first + place < count && place < kParticles;
    MovingThread<kLedger, Movable::kBodies, Real> mover;
    if (moves) {
        awaitPrevious();
        if constexpr (kTogether) {
            mover.loadForList(arrays, params, colliders, id, present, kMeanwhile);
            shared.near.list(id, place, withoutPlanes(colliders, mover.near));
            if (shared.near.count <= kMeanwhile)
                shared.near.look(arrays, params, colliders, {mover_thread / kCornerParts, 2});
        } else if (present) {
            mover.load(arrays, params, colliders, id);
            mover.meetColliders(arrays, params, colliders, LooksItself<>{});
        }
    } else {
        gatherParticle<T, kLedger>(arrays, params, id, present,
                                   [&](const Wrench<Real>& load, const Tally<Real>& tally) {
                                       shared.sums[place] = load;
                                       if constexpr (kLedger) shared.tallies[place] = tally;
                                   });
    }
    __syncthreads();
    if constexpr (kTogether) {
        if (shared.near.count > kMeanwhile) {
            constexpr uint32_t kGroups = substepThreads(true) / kCornerParts;
            shared.near.look(arrays, params, colliders, {threadIdx.x / kCornerParts, kGroups});
            __syncthreads();
        }
    }
    if (!moves || !present) return;
    if constexpr (kTogether)
        mover.meetColliders(arrays, params, colliders,
                            FoundByOthers<Real>{shared.near.found[place], mover.near});
    mover.finish(arrays, params, shared.sums[place], kLedger ? shared.tallies[place] : Tally<Real>{});
}
/// The same, each moved by the first of its threads.
template <uint32_t T, bool kLedger, class Real, class Colliders>
__device__ __forceinline__ void stepAlone(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                          const Colliders& colliders, uint32_t first) {
    const uint32_t k = first + threadIdx.x / T;
    const uint32_t id = workAt(arrays, params, k), count = workCount(arrays, params);
    if (first >= count) return;
    gatherParticle<T, kLedger>(arrays, params, id, k < count,
                               [&](const Wrench<Real>& load, const Tally<Real>& tally) {
                                   if (k >= count) return;
                                   MovingThread<kLedger, Movable::kBodies, Real> mover;
                                   mover.load(arrays, params, colliders, id);
                                   mover.meetColliders(arrays, params, colliders, LooksItself<>{});
                                   mover.finish(arrays, params, load, tally);
                               });
}

/// The first kMaxProjectiles blocks do one projectile each, since their rows are the longest, the others the
/// bodies' particles: all, or those of the work list. Started while the substep before still runs:
/// what no substep changes is read before its end is waited for. kOnlyPlanes: as PlanesOnly.
/// __grid_constant__: what lands hard is told the arrays by their address.
template <uint32_t T, bool kMovesApart, bool kLedger, bool kOnlyPlanes, class Real>
__global__ void __launch_bounds__(substepThreads(kMovesApart),
                                  kLedger ? 2 : blocksAtOnce(T, kMovesApart, kOnlyPlanes))
    substepKernel(const __grid_constant__ SubstepArrays<Real> arrays,
                  const __grid_constant__ StepParams<Real> params) {
    const uint32_t block = blockIdx.x;
    letNextStart();
    const auto& colliders = seenColliders<kOnlyPlanes>(params.colliders);
    if (block < kMaxProjectiles) {
        awaitPrevious();
        const uint32_t shot = params.in_bodies + block;
        if (arrays.work.movesProjectile(shot))
            stepProjectile<kMovesApart, kLedger>(arrays, params, colliders, shot);
        return;
    }
    const uint32_t first = (block - kMaxProjectiles) * (kSubstepBlock / T);
    if constexpr (kMovesApart)
        stepApart<T, kLedger, kOnlyPlanes>(arrays, params, colliders, first);
    else
        stepAlone<T, kLedger>(arrays, params, colliders, first);
}

}  // namespace demolish
