// SPDX-License-Identifier: Apache-2.0
// Particle size, live: rebuilds on a worker after the slider has rested, with a bar and Cancel.
#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "app/panel/widgets.h"
#include "app/session/paint_names.h"

namespace demolish {
namespace {

void showRebuild(PanelContext& context) {
    const SessionStatus& status = context.status;
    if (!status.rebuilding && !status.waiting) {
        ImGui::TextDisabled("%u particles, made in %.2f s", status.stats.particles, status.build_seconds);
        return;
    }
    const char* stage = status.rebuilding ? status.rebuild.stage.c_str() : "waiting for the slider to rest";
    ImGui::ProgressBar(static_cast<float>(status.rebuilding ? status.rebuild.fraction : 0),
                       ImVec2(-ImGui::GetFontSize() * 5, 0), stage);
    noteItem(context, "particles.progress");
    ImGui::SameLine();
    if (button(context, "particles.cancel", "Cancel", "Keep the body as it is"))
        context.commands.emplace_back(command::CancelRebuild{});
}

/// Of models with colours at their vertices.
void showPainted(PanelContext& context) {
    constexpr const char* kNone = "only seen";
    std::vector<std::string> names{kNone};
    for (const std::string& channel : paintChannelNames()) names.push_back(channel);
    std::optional<PaintedStrength>& painted = context.shot.painted;
    const int chosen = combo(context, "particles.painted", "Painted colours", names,
                             painted ? names[1 + static_cast<size_t>(painted->channel)] : kNone,
                             "A channel of the colours at the model's vertices: where it is dark, bonds are "
                             "weak. Rebuilds.");
    if (chosen < 0) return;
    painted.reset();
    if (chosen > 0) painted = PaintedStrength{static_cast<PaintChannel>(chosen - 1)};
    context.changed = true;
}

/// Of the size that is chosen, built or not: finer particles need shorter steps in proportion.
void showWork(const PanelContext& context, double size) {
    const SessionStatus& status = context.status;
    ShotWork work;
    work.steps_bonds = !traitsOf(context.shot.method).pattern_turns;
    const double times = status.particle_size / size;
    work.particles = static_cast<uint32_t>(status.stats.particles * times * times * times);
    const double finer = context.shot.substeps ? 1 : status.particle_size / size;
    work.substeps = static_cast<uint32_t>(std::lround(status.substeps_per_frame * finer));
    if (!work.steps_bonds) {
        ImGui::TextDisabled("%u particles, no bond is stepped", work.particles);
        tooltipOnHover("About how many in all bodies. Preset pieces move as rigid bodies.");
        return;
    }
    const double seconds = costOf(work, context.pace).breaking_frame_ms / 1000;
    char text[96];
    std::snprintf(text, sizeof text, "%u particles, %u substeps, to %s", work.particles, work.substeps,
                  shownTime(seconds).c_str());
    seconds > 1 ? ImGui::TextColored(ImVec4(1.0f, 0.55f, 0.40f, 1), "%s", text)
                : ImGui::TextDisabled("%s", text);
    tooltipOnHover(
        "About how many in all bodies, substeps a frame, and how long a frame takes at most, while all of it "
        "breaks. Faster: larger particles, a taller body.");
}

}  // namespace

void showParticlesPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Particles", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const SessionStatus& status = context.status;
    // Sizes that this device steps at a useful rate.
    const double volume = status.body_volume;
    const double most_particles = status.on_gpu ? 200000 : 20000;
    const double finest = std::cbrt(volume / most_particles), coarsest = std::cbrt(volume / 200);
    Fineness& fineness = context.shot.fineness;
    double size = fineness.particle_size ? *fineness.particle_size : status.particle_size;
    const double preset_count =
        context.preset.fineness.particles
            ? *context.preset.fineness.particles
            : (status.on_gpu ? context.preset.fineness.full : context.preset.fineness.draft);
    const double preset = context.preset.fineness.particle_size ? *context.preset.fineness.particle_size
                                                                : std::cbrt(volume / preset_count);
    if (slider(context,
               {"particles.size", "Particle size", "%.2f mm",
                "Mean spacing of the particles. Smaller: finer pieces and more work (halving it costs about "
                "16 times the "
                "time). Rebuilds a quarter of a second after the slider rests."},
               size, {finest, coarsest, true, 1000}, preset)) {
        fineness.particle_size = size;
        fineness.particles.reset();
        context.changed = true;
    }
    if (slider(context,
               {"particles.refine", "Finer at the impact", "%.1f x",
                "Spacing far from where the shot is aimed over that there, 1 to 4; as many particles. Finer "
                "ones need more substeps. Rebuilds."},
               context.shot.refine, {kRefineRange.least, kRefineRange.most}, context.preset.refine))
        context.changed = true;
    if (checkbox(context, "particles.conform", "Even cracks", context.shot.conform,
                 "Cells follow the borders of tough cells. Rebuilds, and breaks a little otherwise."))
        context.changed = true;
    if (context.status.looks != nullptr && context.status.looks->has_colours) showPainted(context);
    showWork(context, size);
    showRebuild(context);
}

}  // namespace demolish
