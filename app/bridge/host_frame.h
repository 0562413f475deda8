// SPDX-License-Identifier: Apache-2.0
// A solver's present frame in the host's memory, from wherever the solver keeps it.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Parts of a frame, one bit each.
enum class FrameParts : uint32_t {
    kParticles = 1u << 0,    ///< instances of the bodies' particles
    kProjectiles = 1u << 1,  ///< instances of all projectile slots
    kFragments = 1u << 2,    ///< the slot of each particle's fragment
    kTransforms = 1u << 3,   ///< of the fragments, at their slots
    kDrawLists = 1u << 4,    ///< interior and exterior surface, cracks, draw commands
    kColours = 1u << 5,      ///< damage, stress and speed of the bodies' particles
    kAll = (1u << 6) - 1,
};
constexpr FrameParts operator|(FrameParts a, FrameParts b) {
    return static_cast<FrameParts>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
constexpr bool has(FrameParts set, FrameParts part) {
    return (static_cast<uint32_t>(set) & static_cast<uint32_t>(part)) != 0;
}

/// As RenderStreams; what was not asked for is empty.
struct HostFrame {
    FrameStats stats;
    std::vector<ParticleInstance> particles;
    std::vector<ParticleInstance> projectiles;  ///< kMaxProjectiles; radius 0 where a slot is not used
    std::vector<uint32_t> particle_fragment;
    std::vector<FragmentTransform> transforms;  ///< one a particle; those of slots in use mean something
    std::vector<SurfaceVertex> interior_vertices;
    std::vector<uint32_t> interior_indices, exterior_indices;
    std::vector<CrackLine> crack_edges;
    std::vector<SurfaceVertex> exterior_vertices;
    DrawCommands commands{};
    std::vector<uint8_t> damage, stress, speed;  ///< as ColourStreams
};

/// `colour`: what ParticleInstance::value shows. Waits for the solver. What others export, and when, is not
/// affected. Throws DeviceError.
HostFrame readFrame(Solver& solver, FrameParts parts = FrameParts::kAll,
                    ParticleColour colour = ParticleColour::kFragment);

}  // namespace demolish
