// SPDX-License-Identifier: Apache-2.0
// The frames of a run as they were drawn, so that a person can scrub back.
#pragma once
#include <cstddef>
#include <future>
#include <memory>
#include <vector>

#include "app/bridge/frame_bridge.h"
#include "app/session/recorded_array.h"
#include "app/session/recorded_effects.h"
#include "app/session/recorded_outside.h"
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Streams that change only when something breaks; frames in between share them.
struct RecordedDrawList {
    std::vector<uint32_t> particle_fragment;
    std::vector<uint8_t> damage;  ///< as ColourStreams
    RecordedArray<SurfaceVertex> interior_vertices;
    RecordedArray<uint32_t> interior_indices;
    RecordedOutside outside;
    DrawCommands commands{};
    std::vector<uint32_t> slots;  ///< slots in use, ascending
    size_t bytes = 0;             ///< of all of it
};

struct RecordedFrame {
    std::shared_ptr<const RecordedDrawList> draw_list;
    std::vector<FragmentTransform> transforms;  ///< of draw_list->slots
    /// Frames in which no crack has opened or closed share them.
    std::shared_ptr<const std::vector<CrackLine>> crack_lines;
    std::vector<ParticleInstance> projectiles;
    std::vector<uint8_t> stress, speed;              ///< as ColourStreams
    std::shared_ptr<const RecordedEffects> effects;  ///< null: there are none
    FrameStats stats;
};

class Recording {
  public:
    /// Beyond `memory_limit` bytes nothing more is recorded.
    explicit Recording(size_t memory_limit) : memory_limit_(memory_limit) {}

    void clear();
    /// The frame that a tap sees, but for the projectiles; it follows the one that was added last. Megabytes
    /// of new memory take milliseconds to fill: that goes on by itself, and ends before finishCopies() does,
    /// which has to be called before the next transfer and before a frame is looked at. `outside_vertices`:
    /// as StreamSizes::exterior_vertices.
    RecordedFrame read(FrameChange change, const ReadStream& stream, const ColourBytes& colours,
                       const FrameStats& stats, size_t outside_vertices);
    void finishCopies() {
        if (copying_.valid()) copying_.get();
    }
    /// Unless the recording is full.
    void add(RecordedFrame frame);
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
    std::shared_ptr<const RecordedDrawList> readDrawList(const ReadStream& read,
                                                         std::span<const uint8_t> damage,
                                                         size_t outside_vertices);
    std::shared_ptr<const std::vector<CrackLine>> readCracks(const ReadStream& read,
                                                             const DrawCommands& commands) const;
    std::shared_ptr<const RecordedEffects> readEffects(const ReadStream& read, const FrameStats& stats);
    void replayEffects(size_t frame, engine::FractureMesh& mesh) const;
    /// Did something break since the frame recorded last?
    bool breaksWith(const FrameStats& stats) const {
        return frames_.empty() || frames_.back().stats.bonds_broken != stats.bonds_broken;
    }

    size_t memory_limit_;
    size_t bytes_ = 0;
    std::vector<RecordedFrame> frames_;
    EffectsRecorder effects_;
    std::future<void> copying_;
};

}  // namespace demolish
