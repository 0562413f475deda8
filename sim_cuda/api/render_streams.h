// SPDX-License-Identifier: Apache-2.0
// Where the solver writes one frame for drawing. The memory belongs to the renderer: GL buffers mapped for
// CUDA, or plain memory on the CPU and copy paths. Pointers are valid during one exportFrame() call only and
// are never kept.
#pragma once
#include <cstddef>
#include <cstdint>

#include "sim_cuda/api/fracture_geometry.h"

namespace demolish {

/// Rigid motion of one fragment: p -> rotate(rotation, p) + translation. 32 bytes (std430: two vec4).
struct FragmentTransform {
    Float4 rotation{0, 0, 0, 1};  ///< unit quaternion x y z w
    Float3 translation;           ///< m
    uint32_t age : 24 = 0;        ///< frames since the fragment came into being; 0 while it is the whole body
    uint32_t shrink : 8 = 0;      ///< steps by which it is drawn smaller; p is scaled before it is turned
};
static_assert(sizeof(FragmentTransform) == 32);

/// Of FragmentTransform: the scale is 1 less so much for each step (shaders/common/body.glsl knows it, too).
inline constexpr float kShrinkStep = 1.0f / 256;

/// One sphere of the particle view, 32 bytes.
struct ParticleInstance {
    Float3 position;    ///< m
    float radius;       ///< m
    float value;        ///< the colour channel asked for, 0..1
    uint32_t fragment;  ///< fragment slot
    uint32_t reserved[2];
};
static_assert(sizeof(ParticleInstance) == 32);

/// As GL's DrawElementsIndirectCommand.
struct DrawElementsCommand {
    uint32_t count, instance_count, first_index;
    int32_t base_vertex;
    uint32_t base_instance;
};

/// A crack edge that shows, and how wide the crack is there, 8 bytes (shaders/common/crack.glsl knows it,
/// too).
struct CrackLine {
    uint32_t edge;    ///< of FractureGeometry::crack_edges
    uint32_t widths;  ///< m, >= 0, at vertex_0 and vertex_1, 2 x float16, the former in the low half

    bool operator==(const CrackLine&) const = default;
};
static_assert(sizeof(CrackLine) == 8);

/// Counts written by the device, read by indirect draws.
struct DrawCommands {
    DrawElementsCommand interior;  ///< exposed interior faces: count = indices
    DrawElementsCommand cracks;    ///< ribbons: count = 6 corner indices, instance_count = lines shown
    DrawElementsCommand exterior;  ///< the outside: count = indices
};

/// One grain of grit or one spark, 32 bytes.
struct GrainInstance {
    Float3 position;   ///< m
    float size;        ///< m, across; 0: none
    uint32_t turn[2];  ///< grit: quaternion x y z w, 4 x snorm16, x in the low half; spark: velocity in m/s,
                       ///< 3 x float16, and age in s
    uint32_t seed;     ///< of its shape
    float heat;        ///< 0: grit; a spark 1 as it is born, then less
};
static_assert(sizeof(GrainInstance) == 32);

/// One puff of dust or smoke, 32 bytes.
struct PuffInstance {
    Float3 position;  ///< m
    float radius;     ///< m; 0: none
    float depth;      ///< optical depth through its middle
    float age;        ///< s
    uint32_t seed;
    float heat;  ///< 0: dust of the material, 1: smoke
};
static_assert(sizeof(PuffInstance) == 32);

/// As GL's DrawArraysIndirectCommand.
struct DrawArraysCommand {
    uint32_t count, instance_count, first, base_instance;
};

/// Slots in use of the effects' streams; slots that hold nothing are drawn as nothing.
struct EffectCommands {
    DrawArraysCommand grains;  ///< 36 vertices each, twelve faces
    DrawArraysCommand puffs;   ///< 4 each, a strip
};
constexpr EffectCommands effectCommands(uint32_t grains, uint32_t puffs) {
    return {{36, grains, 0, 0}, {4, puffs, 0, 0}};
}

enum class ParticleColour : uint32_t { kFragment, kDamage, kStress, kSpeed };

template <class T>
struct Stream {
    T* data = nullptr;
    size_t capacity = 0;  ///< elements
};

/// What the particle view is coloured by besides the fragment: a byte a particle of the bodies, 255 for 1.
/// All of them or none.
struct ColourStreams {
    Stream<uint8_t> damage, stress, speed;
};

inline constexpr size_t kExteriorChunk = 64;
constexpr size_t exteriorChunks(size_t vertices) {
    return (vertices + kExteriorChunk - 1) / kExteriorChunk;
}

/// An empty stream is not written. A fragment's slot is the lowest particle id in it.
struct RenderStreams {
    Stream<ParticleInstance> particles;       ///< one per particle and projectile (projectiles last)
    Stream<ParticleInstance> projectiles;     ///< those alone, for frames in which nothing else moved
    Stream<uint32_t> particle_fragment;       ///< slot of each particle's fragment
    Stream<FragmentTransform> transforms;     ///< indexed by slot; particle capacity
    Stream<SurfaceVertex> interior_vertices;  ///< exposed faces, rest positions after relaxation
    Stream<uint32_t> interior_indices;
    Stream<uint32_t>
        exterior_indices;  ///< into the exterior vertices: mesh triangles, cut where they are cracked
    Stream<CrackLine> crack_edges;  ///< those that show, in ascending order; which of them changes only with
                                    ///< `commands`, their widths with every motion
    /// The outside, which slides where it cracks; written in whole chunks of kExteriorChunk vertices: all of
    /// them into fresh streams, else those of which one has moved since the last export into streams that
    /// were not fresh.
    Stream<SurfaceVertex> exterior_vertices;
    Stream<uint32_t> exterior_chunks;  ///< per chunk: 1 where this export wrote it
    Stream<DrawCommands> commands;     ///< one
    /// Written while FrameStats::effects_shown. All of them or none.
    Stream<GrainInstance> grains;
    Stream<PuffInstance> puffs;
    Stream<EffectCommands> effect_commands;  ///< one
    ParticleColour colour = ParticleColour::kFragment;
    ColourStreams colours;  ///< for a recording, whatever `colour` is
};

}  // namespace demolish
