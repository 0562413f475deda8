// SPDX-License-Identifier: Apache-2.0
// Fixed places: nothing ever covers the body.
#include "app/panel/layout.h"

#include <imgui.h>

#include <algorithm>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

float columnWidth() {
    return std::min(ImGui::GetFontSize() * 22, ImGui::GetIO().DisplaySize.x * 0.4f);
}
float transportHeight() {
    return ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
}
float statusHeight() {
    return ImGui::GetTextLineHeight() + ImGui::GetStyle().WindowPadding.y;
}

template <class Content>
void fixedWindow(const char* name, ImVec2 position, ImVec2 size, ImGuiWindowFlags flags,
                 const Content& content) {
    ImGui::SetNextWindowPos(position);
    ImGui::SetNextWindowSize(size);
    if (ImGui::Begin(name, nullptr, kFixed | flags)) content();
    ImGui::End();
}

void showColumn(PanelContext& context) {
    showShotPanel(context);
    showImportPanel(context);
    showBodiesPanel(context);
    showMethodPanel(context);
    showImpactPanel(context);
    showParticlesPanel(context);
    showMaterialPanel(context);
    showEffectsPanel(context);
    showViewPanel(context);
    showLightPanel(context);
    showEnergyPanel(context);
    ImGui::Separator();
    checkbox(context, "panel.advanced", "More settings", context.state.advanced,
             "Shows the knobs that are seldom turned");
}

}  // namespace

PictureArea pictureArea(const PanelState& state) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const float left = state.show_panels ? columnWidth() : 0;
    const float below = state.show_panels ? transportHeight() + statusHeight() : 0;
    PictureArea area;
    area.x = static_cast<int>(left * scale.x);
    area.width = std::max(16, static_cast<int>((display.x - left) * scale.x));
    area.height = std::max(16, static_cast<int>((display.y - below) * scale.y));
    return area;
}

void showPanels(PanelContext& context) {
    context.items.clear();
    showHelp(context);
    if (!context.state.show_panels) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float column = columnWidth(), transport = transportHeight(), status = statusHeight();
    // The statistics stay in sight below the panels that scroll; as high as they were in the frame before.
    const float statistics = std::min(context.state.statistics_height, 0.6f * display.y);
    const float above = display.y - status - statistics;
    fixedWindow("panels", ImVec2(0, 0), ImVec2(column, above), 0, [&] { showColumn(context); });
    fixedWindow(
        "statistics", ImVec2(0, above), ImVec2(column, statistics), ImGuiWindowFlags_NoScrollbar, [&] {
            showStatisticsPanel(context);
            context.state.statistics_height = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
        });
    fixedWindow("transport", ImVec2(column, display.y - status - transport),
                ImVec2(display.x - column, transport), ImGuiWindowFlags_NoScrollbar,
                [&] { showTransportBar(context); });
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().WindowPadding.x, ImGui::GetStyle().WindowPadding.y / 2));
    fixedWindow("status", ImVec2(0, display.y - status), ImVec2(display.x, status),
                ImGuiWindowFlags_NoScrollbar, [&] { showStatusBar(context); });
    ImGui::PopStyleVar();
}

}  // namespace demolish
