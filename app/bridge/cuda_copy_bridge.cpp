// SPDX-License-Identifier: Apache-2.0
// Device memory, pinned host memory that grows with what is in use, GL.
#include "app/bridge/cuda_copy_bridge.h"

#include <algorithm>

#include "app/bridge/cuda_check.h"
#include "app/bridge/cuda_stream.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {
using engine::StreamId;

struct CudaCopyBridge::Memory {
    std::array<size_t, kStreamCount> bytes{};
    std::array<void*, kStreamCount> device{};
    std::array<PinnedMemory, kStreamCount> pinned;

    explicit Memory(const std::array<size_t, kStreamCount>& sizes) : bytes(sizes) {}
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory() {
        for (auto* block : device) cudaFree(block);
    }

    void allocate() {
        for (size_t i = 0; i < kStreamCount; ++i)
            checkCuda(cudaMalloc(&device[i], bytes[i]), "allocating the copy path's memory");
    }
};

CudaCopyBridge::CudaCopyBridge(engine::FractureMesh& mesh, const Solver& solver,
                               const std::string& why_not_interop)
    : mesh_(mesh), stream_(streamOf(solver)), memory_(std::make_unique<Memory>(streamBytes(mesh))) {
    note_ = why_not_interop;
    memory_->allocate();
}

CudaCopyBridge::~CudaCopyBridge() = default;

const std::byte* CudaCopyBridge::bring(StreamId id, size_t elements, size_t first) {
    const auto index = static_cast<size_t>(id);
    const size_t before = std::min(first * kStreamElementBytes[index], memory_->bytes[index]);
    const size_t wanted = std::min(elements * kStreamElementBytes[index], memory_->bytes[index] - before);
    if (wanted == 0) return nullptr;
    auto* host = static_cast<std::byte*>(memory_->pinned[index].atLeast(before + wanted));
    copyToHost(host + before, static_cast<const std::byte*>(memory_->device[index]) + before, wanted, stream_,
               "copying the frame");
    mesh_.stream(id).upload({host + before, wanted}, before);
    return host;
}

void CudaCopyBridge::transfer(Solver& solver, const FrameRequest& request) {
    const FrameChange change = history_.next(solver.stats(), request.colour, request.fresh);
    std::array<void*, kStreamCount> data{};
    const bool with_effects = solver.stats().effects_shown;
    for (const StreamId id : streamsOf(change, with_effects))
        data[static_cast<size_t>(id)] = memory_->device[static_cast<size_t>(id)];
    mesh_.showEffects(with_effects, solver.stats().effects_moving);
    RenderStreams streams = streamsAt(data, memory_->bytes, request.colour);
    streams.projectiles = projectile_block_.stream();
    const size_t tapped = request.tap && change != FrameChange::kProjectiles ? mesh_.particleCount() : 0;
    if (tapped > 0) streams.colours = colourStreamsAt(colours_.atLeast(kColours * tapped), tapped);
    solver.exportFrame(streams, request.fresh);
    solver.synchronize();
    projectile_block_.read(request.projectiles, projectiles_);
    if (change != FrameChange::kProjectiles) bringStreams(change);
    if (change != FrameChange::kProjectiles && with_effects) bringEffects();
    const auto read = [&](StreamId id, size_t first, size_t size) {
        const auto i = static_cast<size_t>(id);
        auto* host = static_cast<std::byte*>(memory_->pinned[i].atLeast(first + size));
        if (id == StreamId::kExteriorVertices)  // more of it than was brought
            copyToHost(host + first, static_cast<const std::byte*>(memory_->device[i]) + first, size, stream_,
                       "copying the frame");
        return std::span<const std::byte>(host + first, size);
    };
    if (request.tap) request.tap(change, read, colourBytesAt(colours_.data(), tapped));
}

void CudaCopyBridge::bringStreams(FrameChange change) {
    const size_t count = mesh_.particleCount();
    if (change == FrameChange::kAll) bring(StreamId::kCommands, 1);
    const auto& commands = *static_cast<const DrawCommands*>(
        memory_->pinned[static_cast<size_t>(StreamId::kCommands)].atLeast(sizeof(DrawCommands)));
    for (const StreamId id : kMotionStreams) bring(id, motionElements(id, count, commands));
    if (change == FrameChange::kMotion) return;
    bring(StreamId::kParticleFragment, count);
    const auto* indices =
        reinterpret_cast<const uint32_t*>(bring(StreamId::kInteriorIndices, commands.interior.count));
    const DrawListUse use =
        drawListUse(commands, {indices, indices == nullptr ? 0 : commands.interior.count});
    bring(StreamId::kInteriorVertices, use.interior_vertices);
    bring(StreamId::kExteriorIndices, use.exterior_indices);
    const size_t vertices =
        memory_->bytes[static_cast<size_t>(StreamId::kExteriorVertices)] / sizeof(SurfaceVertex);
    const size_t chunks = exteriorChunks(vertices);
    const auto* flags = reinterpret_cast<const uint32_t*>(bring(StreamId::kExteriorChunks, chunks));
    const WrittenVertices outside = writtenVertices({flags, flags == nullptr ? 0 : chunks}, vertices);
    bring(StreamId::kExteriorVertices, outside.count, outside.first);
}

void CudaCopyBridge::bringEffects() {
    const auto& commands = *reinterpret_cast<const EffectCommands*>(bring(StreamId::kEffectCommands, 1));
    bring(StreamId::kGrains, commands.grains.instance_count);
    bring(StreamId::kPuffs, commands.puffs.instance_count);
}

}  // namespace demolish
