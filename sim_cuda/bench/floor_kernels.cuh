// SPDX-License-Identifier: Apache-2.0
// The floor's substep on the GPU in three layouts. Each is a plain gather: nobody adds to a neighbour.
#pragma once
#include <cooperative_groups.h>

#include "sim_cuda/bench/floor_problem.h"

namespace demolish {

inline constexpr uint32_t kFloorBlock = 128, kWarp = 32;

/// One instant of all particles, four arrays.
struct FloorStateArrays {
    Vec4<float>* position;
    Vec4<float>* rotation;
    Vec4<float>* velocity;
    Vec4<float>* spin;
};

struct FloorArrays {
    FloorStateArrays in, out;
    /// Rows: first slot of each particle, and the end. Transposed: first slot of each warp, and the end; slot
    /// k of the warp's particle l is k 32 + l beyond the first.
    const uint32_t* row;
    const uint32_t*
        other;  ///< kNoOther: no bond, in transposed rows that are shorter than the warp's longest
    FloorRest* rest;
    uint32_t count;
    FloorConstants constants;
};

__device__ __forceinline__ FloorState loadFloor(const FloorStateArrays& from, uint32_t i) {
    return {xyz(from.position[i]), asQuat(from.rotation[i]), xyz(from.velocity[i]), xyz(from.spin[i])};
}

__device__ __forceinline__ void storeFloor(const FloorStateArrays& to, uint32_t i, const FloorState& state) {
    to.position[i] = withW(state.position, 0.0f);
    to.rotation[i] = asVec4(state.rotation);
    to.velocity[i] = withW(state.velocity, 0.0f);
    to.spin[i] = withW(state.spin, 0.0f);
}

/// Adds a slot, breaks its bond when it is stretched too far.
__device__ __forceinline__ void addFloorSlot(const FloorArrays& arrays, const FloorStateArrays& in,
                                             const FloorState& own, uint32_t other, FloorRest& slot,
                                             FloorLoad& load) {
    const FloorRest bond = slot;
    if (bond.w < 0) return;
    if (addFloorBond(own, loadFloor(in, other), bond, arrays.constants, load)) slot.w = -1;
}

/// The sum of T neighbouring threads' loads, in all of them.
template <uint32_t T>
__device__ __forceinline__ void sumOverThreads(FloorLoad& load) {
    const auto add = [](float& value, uint32_t step) { value += __shfl_xor_sync(0xffffffffu, value, step); };
#pragma unroll
    for (uint32_t step = T / 2; step > 0; step /= 2) {
        add(load.force.x, step);
        add(load.force.y, step);
        add(load.force.z, step);
        add(load.torque.x, step);
        add(load.torque.y, step);
        add(load.torque.z, step);
    }
}

/// T threads a particle, bonds in rows.
template <uint32_t T>
__global__ void __launch_bounds__(kFloorBlock, 1) floorRows(FloorArrays arrays) {
    const uint32_t thread = blockIdx.x * kFloorBlock + threadIdx.x, i = thread / T;
    const bool active = i < arrays.count;
    FloorState own;
    FloorLoad load;
    if (active) {
        own = loadFloor(arrays.in, i);
        const uint32_t last = arrays.row[i + 1];
#pragma unroll 4
        for (uint32_t slot = arrays.row[i] + thread % T; slot < last; slot += T)
            addFloorSlot(arrays, arrays.in, own, arrays.other[slot], arrays.rest[slot], load);
    }
    sumOverThreads<T>(load);
    if (active && thread % T == 0) storeFloor(arrays.out, i, floorMoved(own, load, arrays.constants));
}

/// One thread a particle, a warp's bonds side by side.
inline __global__ void __launch_bounds__(kFloorBlock, 1) floorTransposed(FloorArrays arrays) {
    const uint32_t i = blockIdx.x * kFloorBlock + threadIdx.x;
    if (i >= arrays.count) return;
    const FloorState own = loadFloor(arrays.in, i);
    FloorLoad load;
    const uint32_t last = arrays.row[i / kWarp + 1];
#pragma unroll 4
    for (uint32_t slot = arrays.row[i / kWarp] + i % kWarp; slot < last; slot += kWarp) {
        const uint32_t other = arrays.other[slot];
        if (other != kNoOther) addFloorSlot(arrays, arrays.in, own, other, arrays.rest[slot], load);
    }
    storeFloor(arrays.out, i, floorMoved(own, load, arrays.constants));
}

/// All substeps in one launch with a barrier of the whole grid between them; the bonds of a block's particles
/// stay in shared memory. `substeps` is even, so that the result lies where the start was.
template <uint32_t T>
__global__ void floorResident(FloorArrays arrays, uint32_t per_block, uint32_t substeps) {
    extern __shared__ __align__(16) unsigned char memory[];
    const uint32_t first = min(blockIdx.x * per_block, arrays.count);
    const uint32_t last = min(first + per_block, arrays.count);
    const uint32_t first_slot = arrays.row[first], slots = arrays.row[last] - first_slot;
    auto* rest = reinterpret_cast<FloorRest*>(memory);
    auto* other = reinterpret_cast<uint32_t*>(memory + slots * sizeof(FloorRest));
    for (uint32_t k = threadIdx.x; k < slots; k += blockDim.x) {
        rest[k] = arrays.rest[first_slot + k];
        other[k] = arrays.other[first_slot + k];
    }
    __syncthreads();
    const auto grid = cooperative_groups::this_grid();
    for (uint32_t step = 0; step < substeps; ++step) {
        const FloorStateArrays in = step % 2 == 0 ? arrays.in : arrays.out;
        const FloorStateArrays out = step % 2 == 0 ? arrays.out : arrays.in;
        // The bound is the same for the whole block, so that whole warps meet in the shuffles.
        for (uint32_t base = 0; base < per_block * T; base += blockDim.x) {
            const uint32_t thread = base + threadIdx.x, i = first + thread / T;
            const bool active = i < last;
            FloorState own;
            FloorLoad load;
            if (active) {
                own = loadFloor(in, i);
                const uint32_t end = arrays.row[i + 1] - first_slot;
#pragma unroll 4
                for (uint32_t k = arrays.row[i] - first_slot + thread % T; k < end; k += T)
                    addFloorSlot(arrays, in, own, other[k], rest[k], load);
            }
            sumOverThreads<T>(load);
            if (active && thread % T == 0) storeFloor(out, i, floorMoved(own, load, arrays.constants));
        }
        grid.sync();
    }
}

}  // namespace demolish
