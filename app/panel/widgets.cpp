// SPDX-License-Identifier: Apache-2.0
// Controls that every panel uses.
#include "app/panel/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>

namespace demolish {
namespace {

/// Relative: a float slider must not mark a double that it merely rounded.
bool differs(double a, double b) {
    return std::abs(a - b) > 1e-6 * std::max({std::abs(a), std::abs(b), 1e-9});
}

void showLabel(const char* label, bool marked) {
    ImGui::TextUnformatted(label);
    if (!marked) return;
    ImGui::SameLine(0, 4);
    ImGui::TextColored(ImVec4(1.0f, 0.72f, 0.30f, 1.0f), "*");
}

}  // namespace

void noteItem(PanelContext& context, const char* id) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 top = ImGui::GetWindowDrawList()->GetClipRectMin(),
                 bottom = ImGui::GetWindowDrawList()->GetClipRectMax();
    const float middle = 0.5f * (low.y + high.y);
    if (middle > top.y && middle < bottom.y)
        context.items.note(id, {low.x, low.y, high.x, high.y});
    else if (context.items.isWanted(id))
        ImGui::SetScrollHereY();
}

void tooltipOnHover(const char* text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    // Whoever has clicked here knows it by now; the tip would cover what the click brought up below, as the
    // bar of a rebuild and its Cancel.
    const ImVec2 click = ImGui::GetIO().MouseClickedPos[0], low = ImGui::GetItemRectMin(),
                 high = ImGui::GetItemRectMax();
    if (click.x >= low.x && click.y >= low.y && click.x < high.x && click.y < high.y) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool slider(PanelContext& context, const SliderText& text, double& value, const SliderScale& scale,
            double preset) {
    showLabel(text.label, differs(value, preset));
    auto shown = static_cast<float>(value * scale.shown_per_unit);
    const auto least = static_cast<float>(scale.least * scale.shown_per_unit);
    const auto most = static_cast<float>(scale.most * scale.shown_per_unit);
    ImGui::PushID(text.id);
    ImGui::SetNextItemWidth(-1);
    const int flags = ImGuiSliderFlags_AlwaysClamp | (scale.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    bool changed = ImGui::SliderFloat("##value", &shown, least, most, text.format, flags);
    noteItem(context, text.id);
    tooltipOnHover(text.tooltip);
    if (changed) value = std::clamp(shown / scale.shown_per_unit, scale.least, scale.most);
    if (ImGui::BeginPopupContextItem("menu")) {
        if (ImGui::MenuItem("Reset to the scene's value")) {
            value = preset;
            changed = true;
        }
        ImGui::TextDisabled("Ctrl-click the slider to type a value");
        ImGui::EndPopup();
    }
    ImGui::PopID();
    return changed;
}

bool button(PanelContext& context, const char* id, const char* label, const char* tooltip, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    ImGui::PushID(id);
    const bool pressed = ImGui::Button(label);
    noteItem(context, id);
    ImGui::PopID();
    ImGui::EndDisabled();
    tooltipOnHover(tooltip);
    return pressed;
}

bool checkbox(PanelContext& context, const char* id, const char* label, bool& value, const char* tooltip) {
    const bool changed = ImGui::Checkbox(label, &value);
    noteItem(context, id);
    tooltipOnHover(tooltip);
    return changed;
}

int combo(PanelContext& context, const char* id, const char* label, const std::vector<std::string>& names,
          const std::string& current, const char* tooltip) {
    ImGui::TextUnformatted(label);
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(-1);
    int chosen = -1;
    const bool open = ImGui::BeginCombo("##choice", current.c_str());
    noteItem(context, id);
    if (!open) tooltipOnHover(tooltip);
    if (open) {
        for (size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(names[i].c_str(), names[i] == current)) chosen = static_cast<int>(i);
            noteItem(context, (std::string(id) + "." + names[i]).c_str());
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return chosen;
}

void valueRow(const char* label, const char* format, ...) {
    ImGui::TextDisabled("%s", label);
    const float label_end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    ImGui::SameLine(std::max(ImGui::GetFontSize() * 9.3f, label_end + ImGui::GetStyle().ItemSpacing.x));
    va_list arguments;
    va_start(arguments, format);
    ImGui::PushTextWrapPos(0);
    ImGui::TextV(format, arguments);
    ImGui::PopTextWrapPos();
    va_end(arguments);
}

}  // namespace demolish
