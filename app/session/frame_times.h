// Frame-time statistics: what a report's and the panel's numbers mean.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace demolish {

/// One displayed frame; ms of wall time.
struct FrameSample {
    double frame_ms = 0;  ///< from the start of the step to the finished picture
    double sim_ms = 0;    ///< solver
    double draw_ms = 0;   ///< renderer, as the GPU's timer says
};

/// Linear interpolation between the sorted values (the same rule as NumPy's default); `fraction` 0..1; 0 for
/// no values.
double quantile(std::vector<double> values, double fraction);

struct FrameSummary {
    double fps_median = 0;  ///< 1 / median frame time
    double fps_p1 = 0;      ///< 99 % of the frames are at least this fast: 1 / p99 of the frame time
    double fps_p99 = 0;     ///< 1 / p1 of the frame time
    double frame_ms_p99 = 0;
    double sim_ms = 0, draw_ms = 0;  ///< medians
};
FrameSummary summarise(std::span<const FrameSample> samples);

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
