// SPDX-License-Identifier: Apache-2.0
// Each frame is a column as wide as the time that it simulates.
#include "app/commands/frame_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "app/commands/run_formats.h"
#include "app/commands/svg_writer.h"

namespace demolish {
namespace {

constexpr double kWidth = 1200, kHeight = 680;
constexpr double kLeft = 84, kRight = 1136;
constexpr double kTop = 134, kBottom = 440;            // of the frame times
constexpr double kLowerTop = 502, kLowerBottom = 622;  // of the particles
constexpr const char *kFaint = "#dcdcdc", *kShade = "#f2f5fa", *kGrey = "#666", *kBreakColour = "#c0202a";
constexpr double kGuideRates[] = {60, 240, 600};  // FPS

using Value = std::function<double(const FrameSample&)>;

struct Layer {
    const char* name;
    const char* colour;
    Value value;
};

const std::vector<Layer>& stages() {
    static const std::vector<Layer> kStages = {
        {"simulation", "#e8913a", [](const FrameSample& s) { return s.sim_ms; }},
        {"export and transfer", "#7b5ea7", [](const FrameSample& s) { return s.transfer_ms; }},
        {"drawing (GPU timer)", "#4a90d9", [](const FrameSample& s) { return s.draw_ms; }},
        {"rest: submitting, waiting", "#b4b8be", [](const FrameSample& s) { return s.restMs(); }}};
    return kStages;
}

const std::vector<Layer>& particleKinds() {
    static const std::vector<Layer> kKinds = {
        {"stepped with bonds", "#4f9d69", [](const FrameSample& s) { return s.stats.bonded_particles; }},
        {"in rigid fragments", "#a9d18e", [](const FrameSample& s) {
             return s.stats.awake_particles - std::min(s.stats.awake_particles, s.stats.bonded_particles);
         }}};
    return kKinds;
}

std::string label(const char* pattern, double value) {
    char text[64];
    std::snprintf(text, sizeof text, pattern, value);
    return text;
}

/// One chart: from time and value to px.
struct Frame {
    double from, to;     // s
    double most;         // value at the upper edge
    double top, bottom;  // px

    double x(double time) const {
        return kLeft + (kRight - kLeft) * std::clamp((time - from) / (to - from), 0.0, 1.0);
    }
    double y(double value) const { return bottom - (bottom - top) * std::clamp(value / most, 0.0, 1.0); }
};

void drawLayers(SvgWriter& svg, const Frame& frame, std::span<const FrameSample> samples,
                const std::vector<Layer>& layers) {
    std::vector<double> floor(samples.size(), 0), ceiling(samples.size(), 0);
    for (const auto& layer : layers) {
        std::vector<SvgPoint> edge;
        for (size_t i = 0; i < samples.size(); ++i) {
            ceiling[i] = floor[i] + layer.value(samples[i]);
            edge.push_back({frame.x(i > 0 ? samples[i - 1].stats.time : frame.from), frame.y(ceiling[i])});
            edge.push_back({frame.x(samples[i].stats.time), frame.y(ceiling[i])});
        }
        for (size_t i = samples.size(); i-- > 0;) {
            edge.push_back({frame.x(samples[i].stats.time), frame.y(floor[i])});
            edge.push_back({frame.x(i > 0 ? samples[i - 1].stats.time : frame.from), frame.y(floor[i])});
        }
        svg.area(edge, layer.colour);
        floor = ceiling;
    }
}

void drawValueAxis(SvgWriter& svg, const Frame& frame, int most_ticks, const char* name) {
    const double step = tickStep(frame.most, most_ticks);
    for (double value = 0; value <= frame.most * (1 + 1e-9); value += step) {
        svg.line({kLeft, frame.y(value)}, {kRight, frame.y(value)}, kFaint);
        svg.text({kLeft - 8, frame.y(value) + 4}, label("%g", value), {.anchor = "end", .colour = kGrey});
    }
    svg.text({26, 0.5 * (frame.top + frame.bottom)}, name, {.anchor = "middle", .turn = -90});
}

void drawTimeAxis(SvgWriter& svg, const Frame& frame) {
    const double step = tickStep(frame.to - frame.from, 12);
    const auto first = static_cast<long>(std::ceil(frame.from / step - 1e-9));
    for (long tick = first; static_cast<double>(tick) * step <= frame.to + 1e-9; ++tick) {
        const double time = static_cast<double>(tick) * step;
        svg.line({frame.x(time), frame.bottom}, {frame.x(time), frame.bottom + 5}, kGrey);
        svg.text({frame.x(time), frame.bottom + 20}, label("%g", time),
                 {.anchor = "middle", .colour = kGrey});
    }
    svg.line({kLeft, frame.bottom}, {kRight, frame.bottom}, kGrey);
}

/// Behind everything else, so that frames between phases stand out.
void shadePhases(SvgWriter& svg, const Frame& frame, std::span<const PhaseSummary> rows) {
    for (const auto& row : rows) {
        if (row.times.frames == 0) continue;
        const double from = frame.x(row.phase.from), width = frame.x(row.phase.to) - from;
        svg.rectangle({from, kTop - 48}, width, kBottom - kTop + 48, kShade);
        svg.rectangle({from, kLowerTop}, width, kLowerBottom - kLowerTop, kShade);
    }
}

void namePhases(SvgWriter& svg, const Frame& frame, std::span<const PhaseSummary> rows) {
    for (const auto& row : rows) {
        if (row.times.frames == 0) continue;
        const double from = frame.x(row.phase.from), to = frame.x(row.phase.to), middle = 0.5 * (from + to);
        for (const double edge : {from, to}) svg.line({edge, kTop - 48}, {edge, kBottom}, "#999", 1, "4 3");
        svg.text({middle, kTop - 34}, row.phase.name, {.anchor = "middle", .bold = true});
        svg.text({middle, kTop - 20}, label("%.1f FPS", row.times.fps_median),
                 {.size = 12, .anchor = "middle"});
        if (row.phase.paper_fps > 0)
            svg.text({middle, kTop - 6}, label("paper %.0f", row.phase.paper_fps),
                     {.size = 12, .anchor = "middle", .colour = kGrey});
    }
}

/// Frame rates that one looks for; those too near the floor of the chart are left out.
void drawGuides(SvgWriter& svg, const Frame& frame) {
    for (const double rate : kGuideRates) {
        const double ms = 1000 / rate;
        if (ms > frame.most || frame.bottom - frame.y(ms) < 14) continue;
        svg.line({kLeft, frame.y(ms)}, {kRight, frame.y(ms)}, "#333", 1, "2 3");
        svg.text({kRight + 5, frame.y(ms) + 4}, label("%.0f FPS", rate), {.size = 11, .colour = kGrey});
    }
}

void drawBreaks(SvgWriter& svg, const Frame& frame, std::span<const FrameSample> samples) {
    for (size_t i = 0; i < samples.size(); ++i) {
        if (!samples[i].stats.fracture_changed) continue;
        const double from = frame.x(i > 0 ? samples[i - 1].stats.time : frame.from);
        svg.rectangle({from, kBottom + 27}, std::max(1.0, frame.x(samples[i].stats.time) - from), 8,
                      kBreakColour);
    }
    svg.text({kLeft - 8, kBottom + 35}, "bonds break", {.size = 11, .anchor = "end", .colour = kBreakColour});
}

void drawLegend(SvgWriter& svg, double x, double y, const std::vector<Layer>& layers) {
    for (const auto& layer : layers) {
        svg.rectangle({x, y - 10}, 12, 12, layer.colour);
        svg.text({x + 17, y}, layer.name, {.size = 12});
        x += 40 + 6.6 * static_cast<double>(std::string(layer.name).size());
    }
}

double highest(std::span<const FrameSample> samples, const std::vector<Layer>& layers) {
    double most = 0;
    for (const auto& sample : samples) {
        double sum = 0;
        for (const auto& layer : layers) sum += layer.value(sample);
        most = std::max(most, sum);
    }
    return most;
}

/// The next tick above, so that the axis ends with a number.
double axisEnd(double most, int most_ticks) {
    if (most <= 0) return 1;
    const double step = tickStep(most, most_ticks);
    return step * std::ceil(most / step * (1 - 1e-12));
}

}  // namespace

double tickStep(double length, int most_ticks) {
    const double rough = length / most_ticks;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

std::string frameCurveSvg(std::span<const FrameSample> samples, std::span<const Phase> phases,
                          const std::string& title, const std::string& subtitle) {
    SvgWriter svg(kWidth, kHeight);
    svg.text({kLeft, 28}, title, {.size = 18, .bold = true});
    svg.text({kLeft, 48}, subtitle, {.size = 12, .colour = kGrey});
    if (samples.empty()) return svg.finish();
    const double last = samples.back().stats.time;
    const double each = samples.size() > 1 ? samples[1].stats.time - samples[0].stats.time : last;
    const double first = samples.front().stats.time - each;
    const Frame times{first, last, axisEnd(highest(samples, stages()), 6), kTop, kBottom};
    const double awake = highest(samples, particleKinds());
    const Frame particles{first, last, axisEnd(awake, 4), kLowerTop, kLowerBottom};

    const auto rows = summarisePhases(samples, phases);
    shadePhases(svg, times, std::span(rows).first(phases.size()));
    drawValueAxis(svg, times, 6, "ms per frame");
    drawLayers(svg, times, samples, stages());
    drawGuides(svg, times);
    drawTimeAxis(svg, times);
    drawBreaks(svg, times, samples);
    drawValueAxis(svg, particles, 4, "particles");
    drawLayers(svg, particles, samples, particleKinds());
    drawTimeAxis(svg, particles);
    namePhases(svg, times, std::span(rows).first(phases.size()));
    svg.text({0.5 * (kLeft + kRight), kLowerBottom + 42}, "simulated time, s", {.anchor = "middle"});
    drawLegend(svg, kLeft, 70, stages());
    drawLegend(svg, kLeft, kLowerTop - 8, particleKinds());
    return svg.finish();
}

std::string frameCurveSvg(FinishedRun& run) {
    const BuiltShot& built = run.built;
    const RunReport& report = run.report;
    const size_t bodies = built.setup.bodies.size();
    std::string title =
        built.shot.scene + ": " + std::to_string(built.solver->stats().particles) + " particles";
    if (bodies > 1) title += " in " + std::to_string(bodies) + " bodies";
    std::string subtitle = report.mode + " on " + built.solver->deviceName();
    if (report.width > 0)
        subtitle += ", " + std::to_string(report.width) + "x" + std::to_string(report.height) + " " +
                    report.quality + " by " + report.gl_renderer + ", transfer: " + report.transfer;
    return frameCurveSvg(run.samples, built.shot.phases, title, subtitle);
}

}  // namespace demolish
