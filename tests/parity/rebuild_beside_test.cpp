// SPDX-License-Identifier: Apache-2.0
// One thread makes solvers, which records graphs, while another one steps and brings frames over by interop
// and by copies, as a window does whose particle size is changed while it plays.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <thread>
#include <vector>

#include "app/bridge/cuda_interop_bridge.h"
#include "app/session/built_shot.h"
#include "app/session/frame_output.h"
#include "app/session/scene_file.h"
#include "engine/platform/headless_context.h"
#include "tests/parity/on_the_gpu.h"

namespace demolish::tests {
namespace {

constexpr int kRebuilds = 200;
constexpr size_t kFrames = 40;  // of the shot, then it begins anew

Shot blockThatFalls(uint32_t particles) {
    Shot shot = loadScene("block");
    shot.device = DeviceChoice::kCuda;
    shot.fineness.particles = particles;
    shot.impact.kind = ImpactKind::kDrop;
    shot.impact.velocity = 30;
    shot.impact.arrival_time = 0.03;
    return shot;
}

/// Makes solvers of many sizes, steps each, and forgets it.
class Rebuilds {
  public:
    Rebuilds() : thread_([this] { run(); }) {}
    bool ended() const { return ended_; }
    /// Throws what went wrong.
    int made() {
        thread_.join();
        if (error_) std::rethrow_exception(error_);
        return made_;
    }

  private:
    void run() {
        try {
            for (; made_ < kRebuilds; ++made_) {
                const BuiltShot built = buildShot(blockThatFalls(100 + 7 * (made_ % 60)), {}, {});
                if (built.solver->advanceFrame() != StepStatus::kOk) throw std::runtime_error("a bad step");
            }
        } catch (...) {
            error_ = std::current_exception();
        }
        ended_ = true;
    }
    int made_ = 0;
    std::exception_ptr error_;
    std::atomic<bool> ended_ = false;
    std::thread thread_;
};

class RebuildBeside : public OnTheGpu {
  protected:
    void SetUp() override {
        OnTheGpu::SetUp();
        if (IsSkipped()) return;
        engine::HeadlessOptions options;
        options.cuda_device = eglOrdinal(findCudaDevice().ordinal, std::getenv("CUDA_VISIBLE_DEVICES"));
        context_.emplace(options);
    }
    std::optional<engine::HeadlessContext> context_;
};

using Bytes = std::vector<std::byte>;

/// The particles as they went through the bridge.
Bytes brought(FrameBridge& bridge, Solver& solver, size_t particles, bool fresh) {
    Bytes bytes;
    FrameRequest request;
    request.fresh = fresh;
    request.tap = [&](FrameChange, const ReadStream& read, const ColourBytes&) {
        const auto seen = read(engine::StreamId::kParticles, 0, particles * sizeof(ParticleInstance));
        bytes.assign(seen.begin(), seen.end());
    };
    const ExpectedTransfer expected(&bridge);
    bridge.transfer(solver, request);
    return bytes;
}

TEST_F(RebuildBeside, DisturbsNoFrameByWhicheverWayItTravels) {
    const BuiltShot shown = buildShot(blockThatFalls(600), {}, {});
    Solver& solver = *shown.solver;
    std::vector<uint64_t> undisturbed;
    for (size_t frame = 0; frame < kFrames; ++frame) {
        ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
        undisturbed.push_back(solver.stateHash());
    }
    ASSERT_GT(solver.stats().bonds_broken, 0u);

    // Both get the copy path of their own; a buffer can be registered with CUDA once.
    setenv("DEMOLISH_TRANSFER", "copy", 1);
    FrameOutput by_interop(shown), by_copy(shown);
    unsetenv("DEMOLISH_TRANSFER");
    FrameBridge& copy = by_copy.bridge();
    ASSERT_EQ(copy.kind(), Transfer::kCopy);
    std::string why_not;
    const auto interop = CudaInteropBridge::tryMake(by_interop.mesh(), solver, why_not);
    ASSERT_TRUE(interop) << why_not;
    const size_t particles = solver.stats().particles;
    Rebuilds rebuilds;
    size_t frames = 0;
    while (!rebuilds.ended()) {
        solver.restore(shown.start);
        for (size_t frame = 0; frame < kFrames && !rebuilds.ended(); ++frame, ++frames) {
            interop->prepare();
            ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
            ASSERT_EQ(solver.stateHash(), undisturbed[frame]) << "frame " << frame;
            const Bytes a = brought(*interop, solver, particles, frame == 0);
            const Bytes b = brought(copy, solver, particles, frame == 0);
            ASSERT_EQ(a, b) << "frame " << frame;
        }
    }
    EXPECT_EQ(rebuilds.made(), kRebuilds);
    EXPECT_GT(frames, kFrames);
}

}  // namespace
}  // namespace demolish::tests
