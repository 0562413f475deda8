// Quantiles of frame times.
#include "app/session/frame_times.h"

#include <algorithm>
#include <cmath>

namespace demolish {

double quantile(std::vector<double> values, double fraction) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const auto below = static_cast<size_t>(std::floor(place));
    const size_t above = std::min(below + 1, values.size() - 1);
    const double share = place - static_cast<double>(below);
    return values[below] + share * (values[above] - values[below]);
}

FrameSummary summarise(std::span<const FrameSample> samples) {
    std::vector<double> frame, sim, draw;
    for (const auto& sample : samples) {
        frame.push_back(sample.frame_ms);
        sim.push_back(sample.sim_ms);
        draw.push_back(sample.draw_ms);
    }
    const auto rate = [](double ms) { return ms > 0 ? 1000 / ms : 0; };
    FrameSummary summary;
    summary.fps_median = rate(quantile(frame, 0.5));
    summary.frame_ms_p99 = quantile(frame, 0.99);
    summary.fps_p1 = rate(summary.frame_ms_p99);
    summary.fps_p99 = rate(quantile(frame, 0.01));
    summary.sim_ms = quantile(sim, 0.5);
    summary.draw_ms = quantile(draw, 0.5);
    return summary;
}

void NamedTimes::add(const std::string& name, double ms) {
    const auto known =
        std::find_if(times_.begin(), times_.end(), [&](const auto& entry) { return entry.first == name; });
    if (known != times_.end())
        known->second.push_back(ms);
    else
        times_.push_back({name, {ms}});
}

std::vector<std::pair<std::string, double>> NamedTimes::medians() const {
    std::vector<std::pair<std::string, double>> result;
    for (const auto& [name, values] : times_) result.emplace_back(name, quantile(values, 0.5));
    return result;
}

void FrameHistory::add(const FrameSample& sample) {
    if (samples_.size() == capacity_) samples_.erase(samples_.begin());
    samples_.push_back(sample);
}

}  // namespace demolish
