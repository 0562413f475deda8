// SPDX-License-Identifier: Apache-2.0
// Names of the streams that a simulation writes, without the buffers that hold them.
#pragma once
#include <cstddef>
#include <cstdint>

namespace demolish::engine {

/// Streams written once a frame from outside, in this order of ids.
enum class StreamId : uint32_t {
    kParticles,         ///< 32 B: position 3f, radius, value, fragment u32, 2 x u32
    kParticleFragment,  ///< u32 per particle
    kTransforms,        ///< 32 B: quaternion 4f, translation 3f, age u32
    kInteriorVertices,  ///< 24 B: position 3f, normal oct 2 x snorm16, depth and bend 2 x half, cell u32
    kInteriorIndices,   ///< u32
    kExteriorIndices,   ///< u32, into the exterior vertices
    kCrackEdges,        ///< 8 B: crack edge u32, widths at its ends in m 2 x half
    kExteriorVertices,  ///< 24 B: position 3f, normal oct 2 x snorm16, triangle of its looks u32, cell u32
    kExteriorChunks,    ///< u32 per 64 exterior vertices: which were written last; nothing here reads it
    kCommands,          ///< 60 B: three DrawElementsIndirectCommand: interior, cracks, exterior
    kGrains,            ///< 32 B: position 3f, size, quaternion 4 x snorm16 (of a spark: velocity and age,
                        ///< 4 x half), seed u32, heat
    kPuffs,             ///< 32 B: position 3f, radius, optical depth, age, seed u32, heat
    kEffectCommands,    ///< 32 B: two DrawArraysIndirectCommand: grains, puffs
    kCount
};
/// Places of the commands in that stream.
inline constexpr uint32_t kInteriorCommand = 0, kCrackCommand = 1, kExteriorCommand = 2;
inline constexpr size_t kDrawCommandBytes = 20;
/// The same of the effects.
inline constexpr uint32_t kGrainCommand = 0, kPuffCommand = 1;
inline constexpr size_t kPuffBytes = 32, kEffectCommandBytes = 16, kEffectCommandCount = 2;

}  // namespace demolish::engine
