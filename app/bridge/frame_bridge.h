// SPDX-License-Identifier: Apache-2.0
// The one place where simulation and drawing meet: a solver's frame reaches the renderer's buffers.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/render/stream_id.h"
#include "sim_cuda/api/solver.h"

namespace demolish {
namespace engine {
class FractureMesh;
}

/// How a frame travels. kInterop: the GPU writes GL's buffers itself. kCopy: GPU, pinned host memory, GL.
/// kHost: the CPU solver's memory, GL.
enum class Transfer { kInterop, kCopy, kHost };
const char* transferName(Transfer transfer);

/// How much of a frame has to travel.
enum class FrameChange {
    kProjectiles,  ///< the bodies are as they were exported last
    kMotion,       ///< particles, transforms, grit and dust; what is drawn with them stays
    kAll,
};

/// Remembers what was brought over last.
class ExportHistory {
  public:
    /// What has to travel now that the solver's frame is `stats`; the caller brings it over. What falls
    /// asleep travels once more. `fresh` as in FrameRequest.
    FrameChange next(const FrameStats& stats, ParticleColour colour, bool fresh);
    /// Bodies, grit or dust moved in the frame that was brought over last.
    bool moved() const { return !was_asleep_ || effects_moved_; }

  private:
    uint64_t frame_ = 0;
    uint32_t broken_ = 0;
    bool was_asleep_ = false, effects_moved_ = false;
    ParticleColour colour_ = ParticleColour::kFragment;
};

/// So many bytes of a stream, from one on, as it was written last. They stay until the next transfer, or
/// until the same stream is read again.
using ReadStream = std::function<std::span<const std::byte>(engine::StreamId, size_t first, size_t bytes)>;
/// As ColourStreams.
struct ColourBytes {
    std::span<const uint8_t> damage, stress, speed;
};
/// Takes copies of a frame on its way to the mesh, for a recording. GL's buffers are better not read: a
/// driver moves what is read back into the host's memory, where the GPU then writes it slowly (measured:
/// docs/decisions/recording.md). The streams that `change` speaks of can be read, and there are colours,
/// unless only projectiles have moved.
using FrameTap = std::function<void(FrameChange, const ReadStream&, const ColourBytes&)>;

struct FrameRequest {
    ParticleColour colour = ParticleColour::kFragment;
    uint32_t projectiles = 0;  ///< how many the solver has
    /// The streams hold nothing of this solver's yet (new solver, restored snapshot, replayed frame).
    bool fresh = false;
    FrameTap tap{};
};

class FrameBridge {
  public:
    virtual ~FrameBridge() = default;

    /// Brings the solver's present frame into the mesh's streams. What has not changed since the last call
    /// stays where it is. The GL context of the mesh must be current. Throws DeviceError.
    virtual void transfer(Solver& solver, const FrameRequest& request) = 0;
    /// The solver is about to compute a frame that will be brought over: nothing of the mesh is drawn until
    /// transfer() or release(). A GPU that must change between computing and drawing then does so once a
    /// frame and not twice.
    virtual void prepare() {}
    virtual void release() {}
    virtual Transfer kind() const = 0;

    /// Why the transfer is not the fastest one; empty when it is.
    const std::string& note() const { return note_; }
    /// Where the projectiles are in the frame that was brought last.
    std::span<const ParticleInstance> projectiles() const { return projectiles_; }

  protected:
    std::string note_;
    std::vector<ParticleInstance> projectiles_;
};

/// prepare() for as long as a frame is computed, whatever becomes of it.
class ExpectedTransfer {
  public:
    explicit ExpectedTransfer(FrameBridge* bridge) : bridge_(bridge) {
        if (bridge_ != nullptr) bridge_->prepare();
    }
    ~ExpectedTransfer() {
        if (bridge_ != nullptr) bridge_->release();
    }
    ExpectedTransfer(const ExpectedTransfer&) = delete;
    ExpectedTransfer& operator=(const ExpectedTransfer&) = delete;

  private:
    FrameBridge* bridge_;
};

/// Interop if the GPU that draws is the GPU that computes and registration works; else the copy path; the
/// host path for a solver on the CPU. `mesh` must outlive the bridge.
std::unique_ptr<FrameBridge> makeFrameBridge(engine::FractureMesh& mesh, const Solver& solver);

/// What makeFrameBridge would choose for the current GL context, tried on a small buffer.
struct TransferProbe {
    Transfer transfer = Transfer::kHost;
    std::string note;
};
TransferProbe probeTransfer(bool solver_on_gpu);

/// The ordinal by which EGL knows a CUDA device: CUDA_VISIBLE_DEVICES renumbers CUDA's ordinals and not
/// EGL's.
int eglOrdinal(int cuda_ordinal, const char* cuda_visible_devices);

}  // namespace demolish
