// SPDX-License-Identifier: Apache-2.0
// The streams in one order, with the size of their elements, so that the three bridges count bytes
// alike.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "app/bridge/draw_list_use.h"
#include "app/bridge/frame_bridge.h"
#include "sim_cuda/api/render_streams.h"

namespace demolish {

inline constexpr size_t kStreamCount = static_cast<size_t>(engine::StreamId::kCount);

inline constexpr std::array<size_t, kStreamCount> kStreamElementBytes = {
    sizeof(ParticleInstance), sizeof(uint32_t),     sizeof(FragmentTransform), sizeof(SurfaceVertex),
    sizeof(uint32_t),         sizeof(uint32_t),     sizeof(CrackLine),         sizeof(SurfaceVertex),
    sizeof(uint32_t),         sizeof(DrawCommands), sizeof(GrainInstance),     sizeof(PuffInstance),
    sizeof(EffectCommands)};

/// Streams that change while nothing breaks; the solver's others are draw lists.
inline constexpr std::array<engine::StreamId, 3> kMotionStreams = {
    engine::StreamId::kParticles, engine::StreamId::kTransforms, engine::StreamId::kCrackEdges};
/// How much of one of these is in use.
constexpr size_t motionElements(engine::StreamId id, size_t particles, const DrawCommands& last) {
    return id == engine::StreamId::kCrackEdges ? last.cracks.instance_count : particles;
}

/// Streams of grit and dust, which travel with either while there is any.
inline constexpr std::array<engine::StreamId, 3> kEffectStreams = {
    engine::StreamId::kGrains, engine::StreamId::kPuffs, engine::StreamId::kEffectCommands};
/// All streams that travel with a change.
std::vector<engine::StreamId> streamsOf(FrameChange change, bool with_effects);

/// Points the solver's streams at blocks of memory, given in the order of StreamId; null leaves a
/// stream out.
RenderStreams streamsAt(const std::array<void*, kStreamCount>& data,
                        const std::array<size_t, kStreamCount>& bytes, ParticleColour colour);

/// kColours bytes a particle, one colour after the other, as the solver writes and a tap reads them.
inline constexpr size_t kColours = 3;
ColourStreams colourStreamsAt(void* memory, size_t particles);
ColourBytes colourBytesAt(const void* memory, size_t particles);

std::array<size_t, kStreamCount> streamBytes(const engine::FractureMesh& mesh);

}  // namespace demolish
