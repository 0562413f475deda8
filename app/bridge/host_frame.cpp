// SPDX-License-Identifier: Apache-2.0
// Streams as large as they may become are exported into memory that the solver can write; what is used of
// them is copied.
#include "app/bridge/host_frame.h"

#include <algorithm>
#include <memory>
#include <span>

#include "app/bridge/draw_list_use.h"
#include "app/bridge/frame_memory.h"

#if DEMOLISH_WITH_CUDA
#include "app/bridge/cuda_frame_memory.h"
#endif

namespace demolish {
namespace {

std::unique_ptr<FrameMemory> makeFrameMemory([[maybe_unused]] const Solver& solver) {
#if DEMOLISH_WITH_CUDA
    if (solver.onGpu()) return std::make_unique<CudaFrameMemory>(solver);
#endif
    return std::make_unique<HostFrameMemory>();
}

class FrameReader {
  public:
    FrameReader(Solver& solver, FrameParts parts)
        : solver_(solver), parts_(parts), memory_(makeFrameMemory(solver)) {}

    HostFrame read(ParticleColour colour) {
        reserve();
        streams_.colour = colour;
        const bool fresh = has(parts_, FrameParts::kDrawLists);
        solver_.exportFrame(streams_, fresh);
        HostFrame frame;
        frame.stats = solver_.stats();
        bring(streams_.particles, frame.particles);
        bring(streams_.projectiles, frame.projectiles);
        bring(streams_.particle_fragment, frame.particle_fragment);
        bring(streams_.transforms, frame.transforms);
        bring(streams_.colours.damage, frame.damage);
        bring(streams_.colours.stress, frame.stress);
        bring(streams_.colours.speed, frame.speed);
        if (fresh) bringDrawLists(frame);
        return frame;
    }

  private:
    void reserve() {
        const size_t particles = solver_.stats().particles;
        reserve(FrameParts::kParticles, streams_.particles, particles);
        reserve(FrameParts::kProjectiles, streams_.projectiles, kMaxProjectiles);
        reserve(FrameParts::kFragments, streams_.particle_fragment, particles);
        reserve(FrameParts::kTransforms, streams_.transforms, particles);
        reserve(FrameParts::kColours, streams_.colours.damage, particles);
        reserve(FrameParts::kColours, streams_.colours.stress, particles);
        reserve(FrameParts::kColours, streams_.colours.speed, particles);
        if (!has(parts_, FrameParts::kDrawLists)) return;
        const StreamSizes sizes = solver_.exportSizes();
        reserve(FrameParts::kDrawLists, streams_.interior_vertices, sizes.interior_vertices);
        reserve(FrameParts::kDrawLists, streams_.interior_indices, sizes.interior_indices);
        reserve(FrameParts::kDrawLists, streams_.exterior_vertices, sizes.exterior_vertices);
        reserve(FrameParts::kDrawLists, streams_.exterior_indices, sizes.exterior_indices);
        reserve(FrameParts::kDrawLists, streams_.crack_edges, sizes.crack_edges);
        reserve(FrameParts::kDrawLists, streams_.commands, 1);
    }
    template <class T>
    void reserve(FrameParts part, Stream<T>& stream, size_t elements) {
        if (!has(parts_, part) || elements == 0) return;
        stream = {static_cast<T*>(memory_->reserve(elements * sizeof(T))), elements};
    }

    template <class T>
    void bring(const Stream<T>& stream, std::vector<T>& to) {
        bring(stream, stream.capacity, to);
    }
    template <class T>
    void bring(const Stream<T>& stream, size_t elements, std::vector<T>& to) {
        to.resize(std::min(elements, stream.capacity));
        if (!to.empty()) memory_->read(to.data(), stream.data, to.size() * sizeof(T));
    }
    void bringDrawLists(HostFrame& frame) {
        memory_->read(&frame.commands, streams_.commands.data, sizeof(DrawCommands));
        bring(streams_.interior_indices, frame.commands.interior.count, frame.interior_indices);
        const DrawListUse use = drawListUse(frame.commands, frame.interior_indices);
        bring(streams_.interior_vertices, use.interior_vertices, frame.interior_vertices);
        bring(streams_.exterior_vertices, frame.exterior_vertices);
        bring(streams_.exterior_indices, use.exterior_indices, frame.exterior_indices);
        bring(streams_.crack_edges, frame.commands.cracks.instance_count, frame.crack_edges);
    }

    Solver& solver_;
    FrameParts parts_;
    std::unique_ptr<FrameMemory> memory_;
    RenderStreams streams_;
};

}  // namespace

HostFrame readFrame(Solver& solver, FrameParts parts, ParticleColour colour) {
    return FrameReader(solver, parts).read(colour);
}

}  // namespace demolish
