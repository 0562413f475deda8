// SPDX-License-Identifier: Apache-2.0
// The loop that capture and bench share: step, draw, time it.
#pragma once
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "app/commands/progress_bar.h"
#include "app/session/frame_times.h"
#include "app/session/session.h"
#include "app/session/triangle_counter.h"

namespace demolish {

/// Builds a shot with a progress bar on the way; says so first where it will be slow. Throws Interrupted at
/// once when interrupted, and leaves a thread behind.
BuiltShot buildWithBar(const Shot& shot, const BuildOptions& options);

/// One line on stderr: where it runs and what it breaks.
void announce(const BuiltShot& built);

/// What the session has to say of its shot, if anything: one line on stderr.
void tellMessage(const Session& session);

/// For Session::advance(): moves the bar on within a frame, the one after the first `done` of `all`, and
/// stops it at an interrupt.
FrameWatch watchFrame(ProgressBar& bar, uint64_t done, uint64_t all, const char* label);

class StopWatch {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun_).count();
    }

  private:
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// The session's last frame as one sample. `frame_ms` from the start of its step to the finished picture;
/// `draw_ms` as the renderer's GPU timer says.
FrameSample sampleOf(const Session& session, TriangleCounter& triangles, double frame_ms, double draw_ms);

/// Throws NumericalError with the status' sentence unless it is kOk.
void requireOk(StepStatus status);

}  // namespace demolish
