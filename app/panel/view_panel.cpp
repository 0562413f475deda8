// SPDX-License-Identifier: Apache-2.0
// How the picture is shown.
#include <imgui.h>

#include <cstdint>
#include <cstdio>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

const std::vector<std::string> kModes = {"Surface", "Particles"};
const std::vector<std::string> kColours = {"Fragment", "Damage", "Stress", "Speed"};

/// What the two ends of the colours mean.
void showColourScale(PanelContext& context) {
    char most[32];
    switch (context.view.colour_map) {
        case engine::ColourMap::kFragment:
            return;
        case engine::ColourMap::kDamage:
            std::snprintf(most, sizeof most, "all bonds broken");
            break;
        case engine::ColourMap::kStress:
            std::snprintf(most, sizeof most, "strength");
            break;
        case engine::ColourMap::kSpeed:
            std::snprintf(most, sizeof most, "%.3g m/s", context.status.full_colour_speed);
            break;
    }
    const float width = ImGui::GetContentRegionAvail().x;
    // ImGui has a texture's number in place of a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
    ImGui::Image(ImTextureID(static_cast<uintptr_t>(context.colour_ramp)),
                 ImVec2(width, 0.5f * ImGui::GetTextLineHeight()));
    noteItem(context, "view.scale");
    ImGui::TextUnformatted("0");
    ImGui::SameLine(width - ImGui::CalcTextSize(most).x + ImGui::GetStyle().WindowPadding.x);
    ImGui::TextUnformatted(most);
}

}  // namespace

void showViewPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ViewSettings& view = context.view;
    const int mode = combo(context, "view.mode", "Show", kModes, kModes[static_cast<size_t>(view.mode)],
                           "The broken surface, or the particles behind it");
    if (mode >= 0) view.mode = static_cast<engine::ViewMode>(mode);
    if (view.mode == engine::ViewMode::kParticles) {
        const int colour = combo(context, "view.colour", "Colour by", kColours,
                                 kColours[static_cast<size_t>(view.colour_map)],
                                 "Fragment, share of broken bonds, highest stress, or speed");
        if (colour >= 0) view.colour_map = static_cast<engine::ColourMap>(colour);
        showColourScale(context);
    }
    checkbox(context, "view.cracks", "Cracks", view.show_cracks,
             "Dark hairlines where bonds are broken inside one fragment");
    ImGui::SameLine();
    checkbox(context, "view.floor", "Floor", view.show_floor, "The ground plane");
    bool fine = view.quality == engine::RenderQuality::kFull;
    ImGui::SameLine();
    if (checkbox(context, "view.fine", "Fine", fine, "Soft shadows and ambient occlusion; costs draw time"))
        view.quality = fine ? engine::RenderQuality::kFull : engine::RenderQuality::kDraft;
}

}  // namespace demolish
