// The frames of a run as they were drawn, so that a person can scrub back.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "engine/render/fracture_mesh.h"
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Streams that change only when something breaks; frames in between share them.
struct RecordedDrawList {
    std::vector<uint32_t> particle_fragment;
    std::vector<uint8_t> damage;  ///< as RecordedColours
    std::vector<std::byte> interior_vertices, interior_indices, crack_edges;
    DrawCommands commands{};
    std::vector<uint32_t> slots;  ///< slots in use, ascending
    size_t bytes() const;
};

/// What the particle view is coloured by besides the fragment: a byte a particle, 255 for 1.
struct RecordedColours {
    std::vector<uint8_t> damage, stress, speed;
    /// Null for kFragment.
    std::vector<uint8_t>* of(ParticleColour channel);
};
/// From the mesh's particle stream, of the channel that it was written with.
std::vector<uint8_t> readColour(const engine::FractureMesh& mesh);

struct RecordedFrame {
    std::shared_ptr<const RecordedDrawList> draw_list;
    std::vector<FragmentTransform> transforms;  ///< of draw_list->slots
    std::vector<ParticleInstance> projectiles;
    std::vector<uint8_t> stress, speed;  ///< as RecordedColours
    FrameStats stats;
};

class Recording {
  public:
    /// Beyond `memory_limit` bytes nothing more is recorded.
    explicit Recording(size_t memory_limit) : memory_limit_(memory_limit) {}

    void clear();
    /// Did something break since the frame recorded last? Only then add() wants the damage.
    bool breaksWith(const FrameStats& stats) const {
        return frames_.empty() || frames_.back().stats.bonds_broken != stats.bonds_broken;
    }
    /// Reads the present frame back from the mesh's streams, but for the colours.
    void add(const engine::FractureMesh& mesh, std::span<const ParticleInstance> projectiles,
             RecordedColours colours, const FrameStats& stats);
    /// Writes a recorded frame into the mesh's streams. The particle view's spheres come from the bodies'
    /// seeds, which move with their fragments.
    void replay(size_t frame, engine::FractureMesh& mesh, const SceneSetup& setup,
                ParticleColour colour) const;

    size_t size() const { return frames_.size(); }
    const RecordedFrame& frame(size_t index) const { return frames_[index]; }
    size_t bytes() const { return bytes_; }
    size_t memoryLimit() const { return memory_limit_; }
    bool full() const { return bytes_ >= memory_limit_; }

  private:
    std::shared_ptr<const RecordedDrawList> readDrawList(const engine::FractureMesh& mesh,
                                                         std::vector<uint8_t> damage) const;

    size_t memory_limit_;
    size_t bytes_ = 0;
    std::vector<RecordedFrame> frames_;
};

}  // namespace demolish
