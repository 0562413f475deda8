// SPDX-License-Identifier: Apache-2.0
// The bodies of the scene: which is chosen, which are seen, which may be taken hold of, and of what they are.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panel/widgets.h"
#include "app/session/shot_bodies.h"

namespace demolish {
namespace {

constexpr const char* kOfScene = "as the scene";
constexpr double kDegree = 0.017453292519943295;
constexpr int kMostRows = 8;

std::string idOf(const char* what, size_t body) {
    return std::string("bodies.") + what + "." + std::to_string(body);
}

ImU32 inkOf(bool is_on) {
    return ImGui::GetColorU32(is_on ? ImGuiCol_Text : ImGuiCol_TextDisabled);
}

void drawEye(const ImVec2& middle, float size, bool is_open) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float wide = 0.42f * size, high = is_open ? 0.36f * size : 0.12f * size;
    const ImVec2 left(middle.x - wide, middle.y), right(middle.x + wide, middle.y);
    for (const float side : {-1.0f, 1.0f}) {
        if (!is_open && side < 0) continue;  // a closed lid
        list->AddBezierQuadratic(left, ImVec2(middle.x, middle.y + 1.6f * side * high), right, inkOf(is_open),
                                 1.5f);
    }
    if (is_open) list->AddCircleFilled(middle, 0.14f * size, inkOf(true));
}

void drawLock(const ImVec2& middle, float size, bool is_shut) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float half = 0.26f * size;
    list->AddRectFilled(ImVec2(middle.x - half, middle.y - 0.04f * size),
                        ImVec2(middle.x + half, middle.y + 0.36f * size), inkOf(is_shut), 1);
    const float shift = is_shut ? 0 : 0.24f * size;
    list->PathArcTo(ImVec2(middle.x + shift, middle.y - 0.06f * size), 0.17f * size, 3.14159f, 6.28319f);
    list->PathStroke(inkOf(is_shut), 0, 1.5f);
}

/// A square with a drawing in it; true when it was pressed.
template <class Drawing>
bool iconButton(PanelContext& context, const std::string& id, bool is_on, const char* tooltip,
                const Drawing& draw) {
    const float size = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id.c_str(), ImVec2(size, size));
    noteItem(context, id.c_str());
    tooltipOnHover(tooltip);
    draw(ImVec2(corner.x + 0.5f * size, corner.y + 0.5f * size), size, is_on);
    ImGui::SameLine(0, 2);
    return pressed;
}

void showRow(PanelContext& context, size_t number) {
    SceneBody& body = context.shot.bodies[number];
    if (iconButton(context, idOf("eye", number), !body.hidden, "Draws it, or not; it is there all the same",
                   drawEye)) {
        body.hidden = !body.hidden;
        context.changed = true;
    }
    if (iconButton(context, idOf("lock", number), body.locked,
                   "Keeps it from being chosen and moved in the picture", drawLock)) {
        body.locked = !body.locked;
        context.changed = true;
    }
    const bool chosen = context.state.chosen_body == number;
    const std::string name = nameOf(context.shot, number), id = idOf("name", number);
    ImGui::PushID(id.c_str());
    ImGui::AlignTextToFramePadding();
    if (ImGui::Selectable(name.c_str(), chosen)) context.state.chosen_body = number;
    noteItem(context, id.c_str());
    ImGui::PopID();
    tooltipOnHover(body.material ? body.material->name.c_str() : context.shot.material_name.c_str());
}

void showMaterialOf(PanelContext& context, SceneBody& body) {
    std::vector<std::string> names{kOfScene};
    names.insert(names.end(), context.materials.begin(), context.materials.end());
    const int chosen = combo(context, "bodies.material", "Material of it", names,
                             body.material ? body.material->name : kOfScene,
                             "Strength, density, friction and colours of this body alone");
    if (chosen < 0) return;
    context.material_of_body =
        names[static_cast<size_t>(chosen)] == kOfScene ? std::string() : names[static_cast<size_t>(chosen)];
}

void showPlaceOf(PanelContext& context, SceneBody& body) {
    const double height = context.shot.height;
    float metres[3] = {static_cast<float>(height * body.position.x),
                       static_cast<float>(height * body.position.y),
                       static_cast<float>(height * body.position.z)};
    ImGui::TextUnformatted("Place");
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputFloat3("##place", metres, "%.3f m", ImGuiInputTextFlags_EnterReturnsTrue)) {
        for (float& coordinate : metres)
            coordinate = std::clamp(coordinate, static_cast<float>(kPlaceRange.least),
                                    static_cast<float>(kPlaceRange.most));
        body.position = {metres[0] / height, metres[1] / height, metres[2] / height};
        context.changed = true;
    }
    noteItem(context, "bodies.place");
    tooltipOnHover("x, y (up) and z of its foot; Enter takes them over. Rebuilds.");
    double degrees = body.yaw / kDegree;
    if (slider(context, {"bodies.yaw", "Turned by", "%.0f deg", "About the vertical. Rebuilds."}, degrees,
               {-180, 180}, 0)) {
        body.yaw = degrees * kDegree;
        context.changed = true;
    }
    if (checkbox(context, "bodies.breaks", "Breaks", body.breaks, "Off: it stays whole, whatever hits it"))
        context.changed = true;
}

}  // namespace

void showBodiesPanel(PanelContext& context) {
    const size_t count = context.shot.bodies.size();
    if (count == 0 || !ImGui::CollapsingHeader("Bodies", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const int rows = std::min(static_cast<int>(count), kMostRows);
    const float height =
        static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing() + 2 * ImGui::GetStyle().WindowPadding.y;
    ImGui::BeginChild("list", ImVec2(0, height), true);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), ImGui::GetFrameHeightWithSpacing());
    while (clipper.Step())
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
            showRow(context, static_cast<size_t>(row));
    ImGui::EndChild();
    checkbox(context, "bodies.arrange", "Choose and move by the mouse", context.state.arrange,
             "On: a click into the picture chooses a body, and what is chosen is dragged. Off: a click "
             "shoots.");
    if (!context.state.chosen_body || *context.state.chosen_body >= count) return;
    SceneBody& body = context.shot.bodies[*context.state.chosen_body];
    showMaterialOf(context, body);
    showPlaceOf(context, body);
}

}  // namespace demolish
