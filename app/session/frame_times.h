// SPDX-License-Identifier: Apache-2.0
// Frame-time statistics: what a report's and the panel's numbers mean.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/session/scene_parts.h"
#include "sim_cuda/api/stats.h"

namespace demolish {

/// One displayed frame.
struct FrameSample {
    double frame_ms = 0;     ///< wall time from the start of the step to the finished picture
    double sim_ms = 0;       ///< solver, wall time
    double draw_ms = 0;      ///< renderer, as the GPU's timer says
    double transfer_ms = 0;  ///< export of the frame and its way to the renderer's buffers, wall time
    uint64_t triangles = 0;  ///< in the picture
    FrameStats stats{};

    /// What the other three leave: submission, waiting, the GPU's change from one work to the other; ms.
    double restMs() const;
};

/// Linear interpolation between the sorted values (the same rule as NumPy's default); `fraction` 0..1; 0 for
/// no values.
double quantile(std::vector<double> values, double fraction);

struct FrameSummary {
    size_t frames = 0;
    double fps_median = 0;  ///< 1 / median frame time
    double fps_mean = 0;    ///< frames over the time that all of them took
    double fps_p1 = 0;      ///< 99 % of the frames are at least this fast: 1 / p99 of the frame time
    double fps_p99 = 0;     ///< 1 / p1 of the frame time
    double frame_ms_median = 0, frame_ms_p99 = 0, frame_ms_worst = 0;
    double sim_ms = 0, transfer_ms = 0, draw_ms = 0, rest_ms = 0;  ///< medians
    double substeps = 0;                                           ///< median
    double awake_particles = 0, bonded_particles = 0;              ///< medians, as FrameStats counts them
    double awake_bodies = 0;                                       ///< median
    uint32_t particles = 0;                                        ///< in total
    uint32_t fragments = 0, rigid_fragments = 0, sleeping_fragments = 0;  ///< the most in any frame
    uint64_t triangles = 0;                                               ///< the most in any frame
};
FrameSummary summarise(std::span<const FrameSample> samples);

/// The frames that stepped the solver. A window also shows frames that did not (paused, replayed, not due
/// yet): their rate is not that of a simulation.
std::vector<FrameSample> simulatedFrames(std::span<const FrameSample> samples);

/// One row of a report: the frames of a phase, or a choice of frames that cuts across the phases.
struct PhaseSummary {
    Phase phase;
    FrameSummary times;
    /// Ours over the paper's; 0 where the paper reports nothing or no frame was timed.
    double ratio() const { return phase.paper_fps > 0 ? times.fps_median / phase.paper_fps : 0; }
};

inline constexpr const char* kWhileItBreaksRow = "while it breaks";
inline constexpr const char* kBreakingRow = "breaking";
inline constexpr const char* kAllFramesRow = "all frames";

/// A row for each phase, then kWhileItBreaksRow (from the first frame in which bonds broke to the last),
/// kBreakingRow (those in which bonds broke, so that no median hides them) and kAllFramesRow.
std::vector<PhaseSummary> summarisePhases(std::span<const FrameSample> samples,
                                          std::span<const Phase> phases);

/// The phase in which a frame ends at `time` (s simulated); null when there is none.
const Phase* phaseAt(std::span<const Phase> phases, double time);

/// Medians of named times, in the order in which the names first came.
class NamedTimes {
  public:
    void add(const std::string& name, double ms);
    std::vector<std::pair<std::string, double>> medians() const;

  private:
    std::vector<std::pair<std::string, std::vector<double>>> times_;
};

/// The last samples, oldest first, for graphs.
class FrameHistory {
  public:
    explicit FrameHistory(size_t capacity = 240) : capacity_(capacity) {}
    void add(const FrameSample& sample);
    std::span<const FrameSample> samples() const { return samples_; }

  private:
    size_t capacity_;
    std::vector<FrameSample> samples_;
};

}  // namespace demolish
