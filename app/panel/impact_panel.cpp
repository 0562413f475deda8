// SPDX-License-Identifier: Apache-2.0
// What hits the body, and how fast. The velocity is live: it acts on the next impact.
#include <imgui.h>

#include <cstdio>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

void showMeasuring(PanelContext& context) {
    const ThresholdView& threshold = context.threshold;
    if (!threshold.measuring) {
        if (button(context, "impact.measure", "Measure",
                   "Tries velocities on this body until the threshold is known within 5 %, beside the "
                   "window; after Break at, strengths until it breaks there. Kept for the next time."))
            context.measure_threshold = true;
        return;
    }
    const float width = ImGui::CalcTextSize("Cancel").x + 4 * ImGui::GetStyle().FramePadding.x;
    ImGui::ProgressBar(static_cast<float>(threshold.fraction), ImVec2(-width, 0), "measuring");
    ImGui::SameLine();
    if (button(context, "impact.cancel_measuring", "Cancel", "Stops after the trial that is running."))
        context.cancel_measuring = true;
}

void showThreshold(PanelContext& context) {
    if (!context.threshold.value) return;
    const Threshold& threshold = *context.threshold.value;
    Shot& shot = context.shot;
    const bool breaks = shot.impact.velocity >= threshold.velocity();
    ImGui::TextColored(breaks ? ImVec4(1.0f, 0.72f, 0.30f, 1) : ImVec4(0.6f, 0.75f, 0.9f, 1),
                       "Breaks at about %.*f m/s (%s)", threshold.velocity() < 1 ? 2 : 1,
                       threshold.velocity(), threshold.measured ? "measured" : "predicted");
    noteItem(context, "impact.threshold");
    char text[200];
    std::snprintf(text, sizeof text, "%s. The table says %.3g m/s, within a factor of %.2f.",
                  threshold.source().c_str(), threshold.predicted, threshold.scatter);
    tooltipOnHover(text);
    showMeasuring(context);
    double wish = shot.break_at.value_or(threshold.velocity());
    const double strongest = wish > 60 ? kBreakAtRange.most : 60;
    if (slider(context,
               {"impact.break_at", "Break at", "%.2f m/s",
                "Chooses the material's strength so that this shot breaks the body from this velocity on."},
               wish, {kBreakAtRange.least, strongest, true}, context.preset.break_at.value_or(wish))) {
        shot.break_at = wish;
        context.changed = true;
    }
}

void showKind(PanelContext& context) {
    int kind = static_cast<int>(context.shot.impact.kind);
    const int before = kind;
    ImGui::RadioButton("Iron ball", &kind, static_cast<int>(ImpactKind::kBall));
    noteItem(context, "impact.ball");
    ImGui::SameLine();
    ImGui::RadioButton("Drop", &kind, static_cast<int>(ImpactKind::kDrop));
    noteItem(context, "impact.drop");
    ImGui::SameLine();
    ImGui::RadioButton("None", &kind, static_cast<int>(ImpactKind::kNone));
    noteItem(context, "impact.none");
    if (kind == before) return;
    context.shot.impact.kind = static_cast<ImpactKind>(kind);
    context.changed = true;
}

}  // namespace

void showImpactPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Impact", ImGuiTreeNodeFlags_DefaultOpen)) return;
    Impact& impact = context.shot.impact;
    const Impact& preset = context.preset.impact;
    showKind(context);
    const double fastest = impact.velocity > 60 ? kVelocityRange.most : 60;
    if (slider(context,
               {"impact.velocity", "Impact velocity", "%.1f m/s",
                "Speed at the moment of impact. Acts at once on a ball that has not hit yet, and on every "
                "ball fired later. 0: nothing hits the body."},
               impact.velocity, {0, fastest}, preset.velocity)) {
        impact.times_threshold.reset();
        context.changed = true;
    }
    showThreshold(context);
    const bool ball = impact.kind == ImpactKind::kBall;
    if (button(context, "impact.fire", "Fire",
               "Fires the ball now (Enter). A click into the picture aims at that point.", ball))
        context.commands.emplace_back(command::Fire{});
    if (!ball || !context.state.advanced) return;
    const double height = context.status.body_size;
    double radius = impact.ball_radius > 0 ? impact.ball_radius : height / 12;
    const double preset_radius = preset.ball_radius > 0 ? preset.ball_radius : height / 12;
    if (slider(context,
               {"impact.radius", "Ball radius", "%.1f mm", "Radius of the next iron ball (7800 kg/m3)."},
               radius, {height / 60, height / 3, true, 1000}, preset_radius)) {
        impact.ball_radius = radius;
        context.changed = true;
    }
    double fraction = impact.height_fraction.value_or(0.5);
    if (slider(context,
               {"impact.height", "Hit at height", "%.2f of the body",
                "Where the ball hits, as a share of the body's height; untouched, in the middle of what is "
                "seen of it."},
               fraction, {0.05, 0.95}, preset.height_fraction.value_or(0.5))) {
        impact.height_fraction = fraction;
        context.changed = true;
    }
}

}  // namespace demolish
