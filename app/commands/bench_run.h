// SPDX-License-Identifier: Apache-2.0
// Timed frames: each one is stepped, brought over, drawn and waited for, so that a frame's time holds all its
// work.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/commands/headless_stage.h"
#include "app/commands/shot_options.h"
#include "app/commands/timed_loop.h"

namespace demolish {

enum class BenchMode {
    kSimulateAndDraw,
    kSimulateOnly,  ///< no OpenGL, no export
    kDrawOnly,      ///< a recording of the same frames is drawn; the clock starts when it lies in the buffers
};
const char* modeName(BenchMode mode);

struct BenchPlan {
    BenchMode mode = BenchMode::kSimulateAndDraw;
    uint64_t frames = 0;
    uint64_t warmup = 0;  ///< frames before the timed ones; the shot starts anew after them
};

struct BenchRun {
    std::vector<FrameSample> samples;
    NamedTimes passes;  ///< of the renderer, ms
    StepStatus status = StepStatus::kOk;
};

/// Context, renderer and the target that a benchmark draws into.
class BenchStage {
  public:
    BenchStage(bool on_gpu, const BuiltShot& built, const ShotOptions& options, PictureSize size);

    /// Draws and waits.
    void draw(const Session& session);
    void draw(const engine::FractureMesh* mesh, std::span<const engine::SphereDraw> spheres);
    /// The GPU's time of it. Reading the time stamps is no part of a frame.
    double lastDrawMs();
    /// Waits for what GL was asked to do.
    void wait();
    const engine::ContextInfo& info() const { return headless_.info(); }
    engine::RenderQuality quality() const { return view_.quality; }
    void addPasses(NamedTimes& passes);

  private:
    HeadlessStage headless_;
    engine::FrameView view_;
    engine::FrameCapture target_;
};

/// Runs the plan; stops at the first bad status, or when interrupted, with what was timed so far. `stage` is
/// null when nothing is drawn. For BenchMode::kDrawOnly the session must record.
BenchRun runBenchPlan(const BenchPlan& plan, Session& session, BenchStage* stage);

/// Frames from the start of the shot to the end of its last phase; 120 for a shot without phases.
uint64_t framesOfShot(const Shot& shot);

/// The least simulated time between two frames that follow each other, s; 0 for fewer than two.
double leastSimulated(std::span<const FrameSample> samples);

}  // namespace demolish
