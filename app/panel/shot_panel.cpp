// SPDX-License-Identifier: Apache-2.0
// Scene and model choice.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

void showModelField(PanelContext& context) {
    char path[512] = {};
    std::strncpy(path, context.state.typed_model.c_str(), sizeof path - 1);
    ImGui::TextUnformatted("Model file");
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 4);
    const bool entered = ImGui::InputTextWithHint("##model", "path, or drop a file here", path, sizeof path,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    noteItem(context, "shot.model");
    tooltipOnHover(
        "A mesh in any format that assimp reads (OBJ, PLY, STL, glTF, ...); what is open is closed. It "
        "stands on the floor, scaled to the height below. Or a scene of your own, a file that ends in "
        ".toml.");
    context.state.typed_model = path;
    ImGui::SameLine();
    const bool pressed = button(context, "shot.load", "Load", "Break this file", path[0] != '\0');
    if ((entered || pressed) && path[0] != '\0') context.load_model = path;
}

/// Bodies of a set that are as large as their files say keep their proportions.
void showHeight(PanelContext& context) {
    Shot& shot = context.shot;
    const bool keep_sizes = std::any_of(shot.bodies.begin(), shot.bodies.end(),
                                        [](const SceneBody& body) { return body.keeps_size; });
    if (keep_sizes) {
        context.changed |= slider(
            context,
            {"shot.height", "Size", "%.2f x", "Times the size that the files say. Rebuilds the bodies."},
            shot.height, {0.05, 10, true}, context.preset.height);
        return;
    }
    double height = shot.keeps_size ? context.status.body_size : shot.height;
    const double preset = context.preset.keeps_size ? height : context.preset.height;
    const double lowest = std::min(0.05, height), highest = std::max(10.0, height);
    if (!slider(context, {"shot.height", "Model height", "%.2f m", "Scales the model. Rebuilds the body."},
                height, {std::max(lowest, kHeightRange.least), std::min(highest, kHeightRange.most), true},
                preset))
        return;
    shot.height = height;
    shot.keeps_size = false;
    context.changed = true;
}

}  // namespace

void showShotPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Shot", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const int scene = combo(context, "shot.scene", "Scene", context.scenes, context.shot.scene,
                            "A finished scene: model, material, impact, camera and light");
    if (scene >= 0) context.load_scene = context.scenes[static_cast<size_t>(scene)];
    showModelField(context);
    if (!context.status.repair.empty()) ImGui::TextWrapped("Repaired: %s.", context.status.repair.c_str());
    if (!context.status.size_remark.empty()) ImGui::TextWrapped("%s.", context.status.size_remark.c_str());
    showHeight(context);
    if (!context.state.advanced) return;
    double seed = static_cast<double>(context.shot.seed);
    if (slider(context,
               {"shot.seed", "Seed", "%.0f", "Another packing of the particles: other pieces. Rebuilds."},
               seed, {0, 1000}, static_cast<double>(context.preset.seed))) {
        context.shot.seed = static_cast<uint64_t>(std::llround(seed));
        context.changed = true;
    }
}

}  // namespace demolish
