// SPDX-License-Identifier: Apache-2.0
// Play, step, reset, slow motion, and the timeline of recorded frames.
#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

void showButtons(PanelContext& context) {
    const SessionStatus& status = context.status;
    if (button(context, "transport.play", status.playing ? "Pause" : " Play ", "Plays or pauses (Space)"))
        context.commands.emplace_back(command::TogglePlay{});
    ImGui::SameLine();
    if (button(context, "transport.step_back", "<", "One recorded frame back (left arrow)",
               status.cursor > 0))
        context.commands.emplace_back(command::Scrub{status.cursor - 1});
    ImGui::SameLine();
    if (button(context, "transport.step", ">", "One frame on (right arrow)"))
        context.commands.emplace_back(command::Step{});
    ImGui::SameLine();
    if (button(context, "transport.reset", "Reset", "Whole again, with the impact as it is chosen now (R)"))
        context.commands.emplace_back(command::Reset{});
    ImGui::SameLine();
    if (button(context, "transport.fire", "Fire", "Fires the ball now (Enter)",
               context.shot.impact.kind == ImpactKind::kBall && context.shot.impact.velocity > 0))
        context.commands.emplace_back(command::Fire{});
}

void showSlowMotion(PanelContext& context) {
    auto percent = static_cast<float>(100 * context.shot.time_scale);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 9);
    if (ImGui::SliderFloat("##slow", &percent, 2, 100, "speed %.0f %%",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic)) {
        context.shot.time_scale = std::clamp(percent / 100.0, kTimeScaleRange.least, kTimeScaleRange.most);
        context.changed = true;
    }
    noteItem(context, "transport.speed");
    tooltipOnHover("Slow motion: simulated time per frame, as a share of real time. Fewer substeps a frame.");
    ImGui::SameLine();
    checkbox(context, "transport.real_time", "Real time", context.view.real_time,
             "On: never faster than real time. Off: a simulated frame for every drawn one.");
}

void showTimeline(PanelContext& context) {
    const SessionStatus& status = context.status;
    const int last = static_cast<int>(status.newest);
    int frame = static_cast<int>(status.cursor);
    ImGui::SetNextItemWidth(-1);
    char format[64], tip[256];
    std::snprintf(format, sizeof format, "%%d / %d   %.3f s", last, status.stats.time);
    std::snprintf(
        tip, sizeof tip,
        "Recorded frames (%zu MB of %zu%s): drag to look back. Play goes on from there, and simulates on "
        "from the last one.",
        status.recorded_bytes >> 20, status.memory_limit >> 20,
        status.recorded_frames <= status.newest ? "; full, only the newest frame follows" : "");
    // Where there is nothing to drag, a grab would fill half of the bar.
    ImVec4 grab = ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab);
    if (last == 0) grab.w = 0;
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, grab);
    ImGui::BeginDisabled(last == 0);
    if (ImGui::SliderInt("##timeline", &frame, 0, std::max(1, last), format, ImGuiSliderFlags_AlwaysClamp))
        context.commands.emplace_back(command::Scrub{static_cast<size_t>(frame)});
    noteItem(context, "transport.timeline");
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    tooltipOnHover(tip);
}

}  // namespace

void showTransportBar(PanelContext& context) {
    showButtons(context);
    ImGui::SameLine();
    showSlowMotion(context);
    ImGui::SameLine();
    showTimeline(context);
}

}  // namespace demolish
