// SPDX-License-Identifier: Apache-2.0
// Quantiles of frame times.
#include "app/session/frame_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace demolish {
namespace {

/// The end of a frame is a sum of many steps: it may lie a little beside the decimal that a scene file names.
constexpr double kTimeSlack = 1e-6;  // s

bool endsIn(const Phase& phase, double time) {
    return time > phase.from + kTimeSlack && time <= phase.to + kTimeSlack;
}

}  // namespace

double FrameSample::restMs() const {
    return std::max(0.0, frame_ms - sim_ms - transfer_ms - draw_ms);
}

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
    const auto values = [&](auto value) {
        std::vector<double> all;
        all.reserve(samples.size());
        for (const auto& sample : samples) all.push_back(static_cast<double>(value(sample)));
        return all;
    };
    const auto median = [&](auto value) { return quantile(values(value), 0.5); };
    const auto most = [&](auto value) { return quantile(values(value), 1); };
    const auto rate = [](double ms) { return ms > 0 ? 1000 / ms : 0; };
    const auto frame = values([](const auto& s) { return s.frame_ms; });

    FrameSummary summary;
    summary.frames = samples.size();
    summary.frame_ms_median = quantile(frame, 0.5);
    summary.frame_ms_p99 = quantile(frame, 0.99);
    summary.frame_ms_worst = quantile(frame, 1);
    summary.fps_median = rate(summary.frame_ms_median);
    summary.fps_mean = static_cast<double>(frame.size()) * rate(std::reduce(frame.begin(), frame.end()));
    summary.fps_p1 = rate(summary.frame_ms_p99);
    summary.fps_p99 = rate(quantile(frame, 0.01));
    summary.sim_ms = median([](const auto& s) { return s.sim_ms; });
    summary.transfer_ms = median([](const auto& s) { return s.transfer_ms; });
    summary.draw_ms = median([](const auto& s) { return s.draw_ms; });
    summary.rest_ms = median([](const auto& s) { return s.restMs(); });
    summary.substeps = median([](const auto& s) { return s.stats.substeps; });
    summary.awake_particles = median([](const auto& s) { return s.stats.awake_particles; });
    summary.bonded_particles = median([](const auto& s) { return s.stats.bonded_particles; });
    summary.awake_bodies = median([](const auto& s) { return s.stats.awake_bodies; });
    if (!samples.empty()) summary.particles = samples.back().stats.particles;
    summary.fragments = static_cast<uint32_t>(most([](const auto& s) { return s.stats.fragments; }));
    summary.rigid_fragments =
        static_cast<uint32_t>(most([](const auto& s) { return s.stats.rigid_fragments; }));
    summary.sleeping_fragments =
        static_cast<uint32_t>(most([](const auto& s) { return s.stats.sleeping_fragments; }));
    summary.triangles = static_cast<uint64_t>(most([](const auto& s) { return s.triangles; }));
    return summary;
}

std::vector<FrameSample> simulatedFrames(std::span<const FrameSample> samples) {
    std::vector<FrameSample> chosen;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen),
                 [](const FrameSample& sample) { return sample.sim_ms > 0; });
    return chosen;
}

std::vector<PhaseSummary> summarisePhases(std::span<const FrameSample> samples,
                                          std::span<const Phase> phases) {
    std::vector<PhaseSummary> rows;
    const auto addRow = [&](const Phase& phase, auto belongs) {
        std::vector<FrameSample> chosen;
        std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen), belongs);
        rows.push_back({phase, summarise(chosen)});
    };
    for (const auto& phase : phases)
        addRow(phase, [&](const FrameSample& sample) { return endsIn(phase, sample.stats.time); });
    const double first = samples.empty() ? 0 : samples.front().stats.time;
    const double last = samples.empty() ? 0 : samples.back().stats.time;
    const auto breaks = [](const FrameSample& sample) { return sample.stats.fracture_changed; };
    const auto first_break = std::find_if(samples.begin(), samples.end(), breaks);
    const auto last_break = std::find_if(samples.rbegin(), samples.rend(), breaks);
    Phase breaking{kWhileItBreaksRow, first, last, 0};
    if (first_break != samples.end()) {
        breaking.from = first_break->stats.time;
        breaking.to = last_break->stats.time;
    }
    addRow(breaking, [&](const FrameSample& sample) {
        return first_break != samples.end() && sample.stats.time >= breaking.from &&
               sample.stats.time <= breaking.to;
    });
    addRow({kBreakingRow, first, last, 0}, breaks);
    addRow({kAllFramesRow, first, last, 0}, [](const FrameSample&) { return true; });
    return rows;
}

const Phase* phaseAt(std::span<const Phase> phases, double time) {
    const auto found =
        std::find_if(phases.begin(), phases.end(), [&](const Phase& phase) { return endsIn(phase, time); });
    return found != phases.end() ? &*found : nullptr;
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
