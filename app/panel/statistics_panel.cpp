// SPDX-License-Identifier: Apache-2.0
// Frame-time graph with the simulation's and the drawing's share stacked, and the counts of the shot.
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

constexpr ImU32 kSimColour = IM_COL32(240, 150, 60, 255), kTransferColour = IM_COL32(150, 115, 200, 255),
                kDrawColour = IM_COL32(90, 170, 240, 255), kOtherColour = IM_COL32(90, 95, 105, 255),
                kLineColour = IM_COL32(255, 255, 255, 90), kRestTextColour = IM_COL32(158, 165, 178, 255);

/// The scale's top: above nearly all frames, so that one hiccup does not flatten the rest.
double graphTop(std::span<const FrameSample> samples) {
    std::vector<double> frames;
    for (const auto& sample : samples) frames.push_back(sample.frame_ms);
    return std::max(1.0, 1.25 * quantile(frames, 0.98));
}

/// What the colours mean and how high the graph is, in its upper edge.
void drawLegend(ImDrawList& list, ImVec2 low, ImVec2 high, double top) {
    float x = low.x + 4;
    const auto word = [&](const char* text, ImU32 colour) {
        list.AddText(ImVec2(x, low.y + 1), colour, text);
        x += ImGui::CalcTextSize(text).x + 8;
    };
    word("sim", kSimColour);
    word("transfer", kTransferColour);
    word("draw", kDrawColour);
    word("rest", kRestTextColour);
    char scale[32];
    std::snprintf(scale, sizeof scale, top < 10 ? "%.1f ms" : "%.0f ms", top);
    x = high.x - ImGui::CalcTextSize(scale).x - 4;
    word(scale, kRestTextColour);
}

void drawGraph(PanelContext& context, std::span<const FrameSample> samples) {
    const float legend = ImGui::GetTextLineHeight() + 2;
    const ImVec2 whole(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 5 + legend);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 low(corner.x, corner.y + legend), high(corner.x + whole.x, corner.y + whole.y);
    const ImVec2 size(high.x - low.x, high.y - low.y);
    ImGui::InvisibleButton("graph", whole);
    noteItem(context, "statistics.graph");
    tooltipOnHover(
        "Time of each frame: orange simulation, violet export and transfer, blue drawing, grey the rest "
        "(waiting for the screen). The line is 1/60 s.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, high, IM_COL32(18, 19, 22, 255), 3);
    const double top = graphTop(samples);
    drawLegend(list, corner, high, top);
    const float width = size.x / 240;
    for (size_t i = 0; i < samples.size(); ++i) {
        const float x = high.x - static_cast<float>(samples.size() - i) * width;
        float y = high.y;
        const auto bar = [&](double ms, ImU32 colour) {
            const float next = std::max(low.y, y - static_cast<float>(std::max(0.0, ms) / top) * size.y);
            list.AddRectFilled(ImVec2(x, next), ImVec2(x + width, y), colour);
            y = next;
        };
        const FrameSample& sample = samples[i];
        bar(sample.sim_ms, kSimColour);
        bar(sample.transfer_ms, kTransferColour);
        bar(sample.draw_ms, kDrawColour);
        bar(sample.restMs(), kOtherColour);
    }
    const double budget = 1000.0 / 60;
    if (budget >= top) return;
    const float y = high.y - static_cast<float>(budget / top) * size.y;
    list.AddLine(ImVec2(low.x, y), ImVec2(high.x, y), kLineColour);
}

/// The numbers of `demolish bench`, of the last frames: the same statistics by the same code.
void showSpeed(const FrameSummary& summary, size_t bodies) {
    valueRow("FPS", "%.1f (p1 %.1f)", summary.fps_median, summary.fps_p1);
    valueRow("Frame p99, worst", "%.1f, %.1f ms", summary.frame_ms_p99, summary.frame_ms_worst);
    valueRow("Sim, transfer, draw", "%.2f, %.2f, %.2f ms", summary.sim_ms, summary.transfer_ms,
             summary.draw_ms);
    tooltipOnHover(
        "Medians of the frames in the graph that were simulated. Transfer: writing the frame and bringing it "
        "to the renderer.");
    valueRow("Awake", "%.0f particles, %.0f/%zu bodies", summary.awake_particles, summary.awake_bodies,
             bodies);
    tooltipOnHover("What costs anything: the others sleep.");
    valueRow("Triangles", "%llu", static_cast<unsigned long long>(summary.triangles));
}

/// Where the scene names phases: the paper's rate for the present one, and ours in its frames so far.
void showPhase(const PanelContext& context, std::span<const FrameSample> simulated) {
    const Phase* phase = phaseAt(context.shot.phases, context.status.stats.time);
    if (phase == nullptr || phase->paper_fps <= 0) return;
    const PhaseSummary row = summarisePhases(simulated, {phase, 1}).front();
    valueRow("Paper's FPS", "%.0f %s, ours x %.2g", phase->paper_fps, phase->name.c_str(), row.ratio());
}

}  // namespace

void showStatisticsPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Statistics", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const auto samples = context.history.samples();
    const auto simulated = simulatedFrames(samples);
    const FrameSummary summary = simulated.empty() ? summarise(samples) : summarise(simulated);
    drawGraph(context, samples);
    showSpeed(summary, context.status.bodies);
    showPhase(context, simulated);
    const FrameStats& stats = context.status.stats;
    valueRow("Particles", "%u of %.3g mm, %.4g kg", stats.particles, 1000 * context.status.particle_size,
             stats.mass);
    valueRow("Bonds", "%u", stats.bonds);
    valueRow("Broken, parted", "%u, %u", stats.bonds_broken, stats.bonds_parted);
    tooltipOnHover(
        "Broken: the bond has failed. Parted, of these: its two ends have left each other; between the "
        "others "
        "the faces of the crack still touch.");
    valueRow("Fragments", "%u, largest %.1f %%", stats.fragments, 100 * stats.largest_fragment_fraction);
    valueRow("Time", "%.3f s, %u x %.4g us", stats.time, context.status.substeps_per_frame,
             1e6 * stats.time_step);
    tooltipOnHover("Simulated; then the substeps of a frame and how long each is.");
    valueRow("Device", "%s, transfer: %s", context.status.device.c_str(), context.status.transfer.c_str());
    if (!context.status.transfer_note.empty()) tooltipOnHover(context.status.transfer_note.c_str());
    valueRow("Drawn by", "%s", context.gl_renderer.c_str());
}

}  // namespace demolish
