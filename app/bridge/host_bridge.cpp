// Upload of a frame that the CPU solver wrote.
#include "app/bridge/host_bridge.h"

#include <algorithm>

namespace demolish {
using engine::StreamId;

HostBridge::HostBridge(engine::FractureMesh& mesh) : mesh_(mesh), bytes_(streamBytes(mesh)) {
    for (size_t i = 0; i < kStreamCount; ++i)
        memory_[i] = std::make_unique_for_overwrite<std::byte[]>(bytes_[i]);
}

void HostBridge::transfer(Solver& solver, ParticleColour colour, uint32_t projectiles, bool fresh) {
    const FrameChange change = history_.next(solver.stats(), colour, fresh);
    std::array<void*, kStreamCount> data{};
    if (change == FrameChange::kAll)
        for (size_t i = 0; i < kStreamCount; ++i) data[i] = memory_[i].get();
    if (change == FrameChange::kMotion)
        for (const StreamId id : kMotionStreams)
            data[static_cast<size_t>(id)] = memory_[static_cast<size_t>(id)].get();
    RenderStreams streams = streamsAt(data, bytes_, colour);
    projectiles_.resize(kMaxProjectiles);
    streams.projectiles = {projectiles_.data(), projectiles_.size()};
    solver.exportFrame(streams, fresh);
    projectiles_.resize(projectiles);
    if (change == FrameChange::kProjectiles) return;

    const size_t count = mesh_.particleCount();
    const auto upload = [&](StreamId id, size_t elements) {
        const auto index = static_cast<size_t>(id);
        const size_t wanted = std::min(elements * kStreamElementBytes[index], bytes_[index]);
        if (wanted > 0) mesh_.stream(id).upload({memory_[index].get(), wanted});
    };
    for (const StreamId id : kMotionStreams) upload(id, count);
    if (change == FrameChange::kMotion) return;
    const DrawListUse use = drawListUse(*streams.commands.data,
                                        {streams.interior_indices.data, streams.interior_indices.capacity});
    upload(StreamId::kParticleFragment, count);
    upload(StreamId::kInteriorIndices, use.interior_indices);
    upload(StreamId::kInteriorVertices, use.interior_vertices);
    upload(StreamId::kExteriorIndices, use.exterior_indices);
    upload(StreamId::kCrackEdges, use.crack_edges);
    upload(StreamId::kCommands, 1);
}

DrawListUse drawListUse(const DrawCommands& commands, std::span<const uint32_t> interior_indices) {
    DrawListUse use;
    use.interior_indices = std::min<size_t>(commands.interior.count, interior_indices.size());
    const auto used = interior_indices.first(use.interior_indices);
    if (!used.empty()) use.interior_vertices = *std::max_element(used.begin(), used.end()) + size_t{1};
    use.exterior_indices = commands.exterior.count;
    use.crack_edges = commands.cracks.instance_count;
    return use;
}

}  // namespace demolish
