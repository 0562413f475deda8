// SPDX-License-Identifier: Apache-2.0
// Upload of a frame that the CPU solver wrote.
#include "app/bridge/host_bridge.h"

#include <algorithm>
#include "engine/render/fracture_mesh.h"

namespace demolish {
using engine::StreamId;

HostBridge::HostBridge(engine::FractureMesh& mesh) : mesh_(mesh), bytes_(streamBytes(mesh)) {
    for (size_t i = 0; i < kStreamCount; ++i)
        memory_[i] = std::make_unique_for_overwrite<std::byte[]>(bytes_[i]);
}

void HostBridge::transfer(Solver& solver, const FrameRequest& request) {
    const FrameChange change = history_.next(solver.stats(), request.colour, request.fresh);
    std::array<void*, kStreamCount> data{};
    const bool with_effects = solver.stats().effects_shown;
    for (const StreamId id : streamsOf(change, with_effects))
        data[static_cast<size_t>(id)] = memory_[static_cast<size_t>(id)].get();
    mesh_.showEffects(with_effects, solver.stats().effects_moving);
    RenderStreams streams = streamsAt(data, bytes_, request.colour);
    projectiles_.resize(kMaxProjectiles);
    streams.projectiles = {projectiles_.data(), projectiles_.size()};
    const size_t tapped = request.tap && change != FrameChange::kProjectiles ? mesh_.particleCount() : 0;
    colours_.resize(std::max(colours_.size(), kColours * tapped));
    if (tapped > 0) streams.colours = colourStreamsAt(colours_.data(), tapped);
    solver.exportFrame(streams, request.fresh);
    projectiles_.resize(request.projectiles);
    if (change != FrameChange::kProjectiles) uploadStreams(streams, change);
    const auto read = [&](StreamId id, size_t first, size_t size) {
        return std::span<const std::byte>(memory_[static_cast<size_t>(id)].get() + first, size);
    };
    if (request.tap) request.tap(change, read, colourBytesAt(colours_.data(), tapped));
}

void HostBridge::upload(StreamId id, size_t elements, size_t first) {
    const auto index = static_cast<size_t>(id);
    const size_t before = std::min(first * kStreamElementBytes[index], bytes_[index]);
    const size_t wanted = std::min(elements * kStreamElementBytes[index], bytes_[index] - before);
    if (wanted > 0) mesh_.stream(id).upload({memory_[index].get() + before, wanted}, before);
}

void HostBridge::uploadStreams(const RenderStreams& streams, FrameChange change) {
    const size_t count = mesh_.particleCount();
    // As they were written last, which need not be now.
    const auto& commands =
        *reinterpret_cast<const DrawCommands*>(memory_[static_cast<size_t>(StreamId::kCommands)].get());
    for (const StreamId id : kMotionStreams) upload(id, motionElements(id, count, commands));
    if (const EffectCommands* effects = streams.effect_commands.data) {
        upload(StreamId::kGrains, effects->grains.instance_count);
        upload(StreamId::kPuffs, effects->puffs.instance_count);
        upload(StreamId::kEffectCommands, 1);
    }
    if (change == FrameChange::kMotion) return;
    const DrawListUse use =
        drawListUse(commands, {streams.interior_indices.data, streams.interior_indices.capacity});
    upload(StreamId::kParticleFragment, count);
    upload(StreamId::kInteriorIndices, use.interior_indices);
    upload(StreamId::kInteriorVertices, use.interior_vertices);
    upload(StreamId::kExteriorIndices, use.exterior_indices);
    const WrittenVertices outside =
        writtenVertices({streams.exterior_chunks.data, exteriorChunks(streams.exterior_vertices.capacity)},
                        streams.exterior_vertices.capacity);
    upload(StreamId::kExteriorVertices, outside.count, outside.first);
    upload(StreamId::kCommands, 1);
}

}  // namespace demolish
