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
    std::array<void*, kStreamCount> data{};
    for (size_t i = 0; i < kStreamCount; ++i) data[i] = memory_[i].get();
    const RenderStreams streams = streamsAt(data, bytes_, colour);
    solver.exportFrame(streams, fresh);

    const size_t count = mesh_.particleCount();
    const auto upload = [&](StreamId id, size_t elements) {
        const auto index = static_cast<size_t>(id);
        const size_t wanted = std::min(elements * kStreamElementBytes[index], bytes_[index]);
        if (wanted > 0) mesh_.stream(id).upload({memory_[index].get(), wanted});
    };
    upload(StreamId::kParticles, count + projectiles);
    upload(StreamId::kParticleFragment, count);
    upload(StreamId::kTransforms, count);
    const uint32_t broken = solver.stats().bonds_broken;
    if (fresh || broken != broken_before_) {
        const DrawListUse use = drawListUse(
            *streams.commands.data, {streams.interior_indices.data, streams.interior_indices.capacity});
        upload(StreamId::kInteriorIndices, use.interior_indices);
        upload(StreamId::kInteriorVertices, use.interior_vertices);
        upload(StreamId::kCrackEdges, use.crack_edges);
        upload(StreamId::kCommands, 1);
        broken_before_ = broken;
    }
    const size_t first = std::min(count, streams.particles.capacity);
    const size_t last = std::min(count + projectiles, streams.particles.capacity);
    projectiles_.assign(streams.particles.data + first, streams.particles.data + last);
}

DrawListUse drawListUse(const DrawCommands& commands, std::span<const uint32_t> interior_indices) {
    DrawListUse use;
    use.interior_indices = std::min<size_t>(commands.interior.count, interior_indices.size());
    const auto used = interior_indices.first(use.interior_indices);
    if (!used.empty()) use.interior_vertices = *std::max_element(used.begin(), used.end()) + size_t{1};
    use.crack_edges = commands.cracks.instance_count;
    return use;
}

}  // namespace demolish
