// SPDX-License-Identifier: Apache-2.0
// Byte counts of the streams and the solver's view of them.
#include "app/bridge/stream_layout.h"

#include <algorithm>

#include "engine/render/fracture_mesh.h"

namespace demolish {
namespace {

template <class T>
Stream<T> streamOf(const std::array<void*, kStreamCount>& data, const std::array<size_t, kStreamCount>& bytes,
                   engine::StreamId id) {
    const auto index = static_cast<size_t>(id);
    return {static_cast<T*>(data[index]), bytes[index] / sizeof(T)};
}

}  // namespace

std::vector<engine::StreamId> streamsOf(FrameChange change, bool with_effects) {
    const auto is = [](const auto& set, engine::StreamId id) {
        return std::find(set.begin(), set.end(), id) != set.end();
    };
    std::vector<engine::StreamId> streams;
    for (uint32_t i = 0; i < kStreamCount && change != FrameChange::kProjectiles; ++i) {
        const engine::StreamId id{i};
        const bool of_effects = is(kEffectStreams, id), of_motion = is(kMotionStreams, id);
        if (of_effects ? with_effects : change == FrameChange::kAll || of_motion) streams.push_back(id);
    }
    return streams;
}

RenderStreams streamsAt(const std::array<void*, kStreamCount>& data,
                        const std::array<size_t, kStreamCount>& bytes, ParticleColour colour) {
    using engine::StreamId;
    RenderStreams streams;
    streams.particles = streamOf<ParticleInstance>(data, bytes, StreamId::kParticles);
    streams.particle_fragment = streamOf<uint32_t>(data, bytes, StreamId::kParticleFragment);
    streams.transforms = streamOf<FragmentTransform>(data, bytes, StreamId::kTransforms);
    streams.interior_vertices = streamOf<SurfaceVertex>(data, bytes, StreamId::kInteriorVertices);
    streams.interior_indices = streamOf<uint32_t>(data, bytes, StreamId::kInteriorIndices);
    streams.exterior_indices = streamOf<uint32_t>(data, bytes, StreamId::kExteriorIndices);
    streams.crack_edges = streamOf<CrackLine>(data, bytes, StreamId::kCrackEdges);
    streams.exterior_vertices = streamOf<SurfaceVertex>(data, bytes, StreamId::kExteriorVertices);
    streams.exterior_chunks = streamOf<uint32_t>(data, bytes, StreamId::kExteriorChunks);
    streams.commands = streamOf<DrawCommands>(data, bytes, StreamId::kCommands);
    streams.grains = streamOf<GrainInstance>(data, bytes, StreamId::kGrains);
    streams.puffs = streamOf<PuffInstance>(data, bytes, StreamId::kPuffs);
    streams.effect_commands = streamOf<EffectCommands>(data, bytes, StreamId::kEffectCommands);
    streams.colour = colour;
    return streams;
}

ColourStreams colourStreamsAt(void* memory, size_t particles) {
    auto* first = static_cast<uint8_t*>(memory);
    return {{first, particles}, {first + particles, particles}, {first + 2 * particles, particles}};
}

ColourBytes colourBytesAt(const void* memory, size_t particles) {
    const auto* first = static_cast<const uint8_t*>(memory);
    return {{first, particles}, {first + particles, particles}, {first + 2 * particles, particles}};
}

std::array<size_t, kStreamCount> streamBytes(const engine::FractureMesh& mesh) {
    std::array<size_t, kStreamCount> bytes{};
    for (size_t i = 0; i < kStreamCount; ++i) bytes[i] = mesh.stream(static_cast<engine::StreamId>(i)).size();
    return bytes;
}

}  // namespace demolish
