// SPDX-License-Identifier: Apache-2.0
// The list of keys and mouse bindings.
#include <imgui.h>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

struct Binding {
    const char* keys;
    const char* meaning;
};

constexpr Binding kBindings[] = {
    {"Click", "shoot the ball at the point under the cursor"},
    {"Left drag / middle drag / Alt+left", "orbit"},
    {"Shift+middle drag / Alt+middle", "pan"},
    {"Wheel / Ctrl+middle drag / Alt+right", "dolly"},
    {"F, Home, A", "frame the body"},
    {"1  3  7  0", "front, side, top, the shot's camera"},
    {"Space", "play, pause"},
    {"Left, right arrow", "one frame back, on"},
    {"R", "reset"},
    {"Enter", "fire the shot's ball"},
    {"Tab", "hide or show the panels"},
    {"Ctrl-click on a slider", "type a value"},
    {"?", "this list"},
};

}  // namespace

void showHelp(PanelContext& context) {
    if (!context.state.show_help) return;
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(centre, ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    if (ImGui::Begin("Keys and mouse", &context.state.show_help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings)) {
        if (ImGui::BeginTable("bindings", 2)) {
            for (const auto& binding : kBindings) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextColored(ImVec4(0.65f, 0.8f, 1.0f, 1), "%s", binding.keys);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(binding.meaning);
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

}  // namespace demolish
