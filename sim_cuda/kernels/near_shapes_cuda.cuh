// SPDX-License-Identifier: Apache-2.0
// Corners on shapes, shared by the threads of a block. The warp that moves particles lists which of them are
// near shapes. A short list it may do by itself while the others gather; else all threads take their share
// once they have gathered. Sixteen threads look at a particle together, and who looks at which changes no
// bit.
#pragma once
#include "sim_cuda/kernels/collider_contact.h"

namespace demolish {

/// Threads of a block that gather; those that move particles apart come on top.
inline constexpr uint32_t kSubstepBlock = 128;

/// Bit c: the particle may touch collider c in this step, as far as bounds say.
template <class Real>
__device__ __forceinline__ uint32_t collidersNear(const StepParams<Real>& params,
                                                  const ColliderSet<Real>& colliders,
                                                  const OwnParticle<Real>& own) {
    if (own.constants.isHeld() || !own.constants.isMovedHere()) return 0;
    uint32_t near = 0;
    forEachCollider(colliders, own, [&](uint32_t c, const TangentPlane<Real>& bound) {
        if (!isClearOf<StepKind::kSubstep>(own, bound.distance - own.constants.floor_radius, params.dt))
            near |= 1u << c;
    });
    return near;
}
/// Without meshes that are too far away to be touched in this step: one node of a grid tells most of what is
/// far from the surface though within the box about it.
template <class Real>
__device__ __forceinline__ uint32_t withoutFarMeshes(const StepParams<Real>& params,
                                                     const ColliderSet<Real>& colliders,
                                                     const OwnParticle<Real>& own, uint32_t near) {
    const LoadedState<Real>& state = own.state;
    for (uint32_t left = near; left != 0; left &= left - 1) {
        const uint32_t c = lowestBit(left);
        if (!colliders.isMesh(c)) continue;
        const Real least = leastDistance(colliders.collider[c], xyz(state.position),
                                         lowPart(state.position, state.velocity, state.spin));
        const Real gap = sureDistance(least) - own.constants.floor_radius;
        if (isClearOf<StepKind::kSubstep>(own, gap, params.dt)) near &= ~(1u << c);
    }
    return near;
}
template <class Real>
__device__ __forceinline__ uint32_t withoutPlanes(const ColliderSet<Real>& colliders, uint32_t near) {
    uint32_t shapes = 0;
    for (; near != 0; near &= near - 1)
        if (const uint32_t c = lowestBit(near); !colliders.isPlane(c)) shapes |= 1u << c;
    return shapes;
}

/// kCornerParts threads look at the corners of particle `id` on each of `shapes`; `found`: by collider.
template <class Real>
__device__ __forceinline__ void lookAtShapes(const SubstepArrays<Real>& arrays,
                                             const StepParams<Real>& params,
                                             const ColliderSet<Real>& colliders, uint32_t id, uint32_t shapes,
                                             FoundOnShape<Real>* found) {
    const OwnParticle<Real> own = loadOwn(arrays, id);
    const TurnsAlone<Real> alone{cornersOf(arrays.corners, id)};
    const CellPose<Real> pose = poseOf(own, alone.cell(params, own));
    const LaneGroup<kCornerParts> lanes{threadIdx.x % kCornerParts};
    for (; shapes != 0; shapes &= shapes - 1) {
        const uint32_t c = lowestBit(shapes);
        const ColliderRows<Real>& rows = colliders.collider[c];
        if (pose.seen.corners.from_seed.empty()) {  // a sphere
            if (lanes.leads()) found[c].tangent = colliders.tangent(c, pose.high, pose.low);
            continue;
        }
        const ShapeFound<Real> at = params.hertz != 0 ? cornersOnShape<false, true>(rows, pose, lanes)
                                                      : cornersOnShape<false, false>(rows, pose, lanes);
        if (lanes.leads()) found[c].points = at.points;
        if (at.has_centre && colliders.isMesh(c))
            found[c].tangent =
                tangentWith(turnedOut(rows.row, at.centre.out), at.centre.distance, pose.high, pose.low);
    }
}

/// Groups of threads that share work, and the number of this thread's.
struct ThreadGroups {
    uint32_t own, all;
};

/// The warp that moves looks at a list of up to so many particles by itself while the others gather, two at a
/// time: the fewer threads share a particle, the longer they gather. With a longer list all together are done
/// sooner.
constexpr uint32_t lookedAtMeanwhile(uint32_t threads) {
    if (threads >= 16) return 2;
    return threads >= 8 ? 4 : 6;
}

/// Particles of a block that are near shapes, and what has been found of them there; in shared memory.
template <uint32_t kParticles, class Real>
struct NearShapes {
    uint32_t count;
    uint32_t id[kParticles];                              ///< of the first `count`
    uint32_t place[kParticles];                           ///< likewise, in the block
    uint32_t shapes[kParticles];                          ///< likewise, bit c: collider c
    FoundOnShape<Real> found[kParticles][kMaxColliders];  ///< by place in the block

    /// All threads of the warp that moves particles, each with its own.
    __device__ __forceinline__ void list(uint32_t own_id, uint32_t own_place, uint32_t own_shapes) {
        const uint32_t lane = threadIdx.x % 32, all = __ballot_sync(0xffffffffu, own_shapes != 0);
        const auto rank = static_cast<uint32_t>(__popc(all & lowBits(lane)));
        if (own_shapes != 0) {
            id[rank] = own_id;
            place[rank] = own_place;
            shapes[rank] = own_shapes;
        }
        if (lane == 0) count = static_cast<uint32_t>(__popc(all));
        __syncwarp();
    }
    /// Groups of kCornerParts threads share the list.
    __device__ __forceinline__ void look(const SubstepArrays<Real>& arrays, const StepParams<Real>& params,
                                         const ColliderSet<Real>& colliders, const ThreadGroups& groups) {
        for (uint32_t k = groups.own; k < count; k += groups.all)
            lookAtShapes(arrays, params, colliders, id[k], shapes[k], found[place[k]]);
    }
};

}  // namespace demolish
