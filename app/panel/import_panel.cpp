// SPDX-License-Identifier: Apache-2.0
// What the model file held, what was done to close it, how large it is: `demolish check`, and its choices.
#include <imgui.h>

#include "app/panel/widgets.h"
#include "app/session/model_shot.h"

namespace demolish {
namespace {

constexpr const char* kNoUnit = "not known: 1 m high";

/// Of a bare model whose format leaves it open.
void showUnit(PanelContext& context) {
    Shot& shot = context.shot;
    if (!shot.bodies.empty() || !refusalOfUnit(shot.model).empty()) return;
    std::vector<std::string> names{kNoUnit};
    names.insert(names.end(), lengthUnitNames().begin(), lengthUnitNames().end());
    const std::string present = lengthUnitName(shot.part.unit);
    const int chosen =
        combo(context, "import.unit", "Unit of the file", names,
              shot.part.unit == 0 ? kNoUnit
              : shot.keeps_size   ? present
                                  : present + ", scaled",
              "The file does not say it. With a unit the model keeps its size. Rebuilds the body.");
    if (chosen < 0) return;
    setUnit(shot, chosen == 0 ? 0 : *lengthUnitOf(names[static_cast<size_t>(chosen)]));
    context.changed = true;
}

void showRepair(PanelContext& context) {
    RepairOptions& repair = context.shot.repair;
    const int chosen =
        combo(context, "import.repair", "Repair", repairModeNames(), repairModeName(repair.mode),
              "How a model that is not closed is made one: auto as far as needed, exact never with a new "
              "surface, remesh always with one, off not at all. Rebuilds the body.");
    if (chosen < 0) return;
    repair.mode = *repairModeOf(repairModeNames()[static_cast<size_t>(chosen)]);
    context.changed = true;
}

void showLooks(PanelContext& context) {
    bool of_file = context.shot.looks == LooksOf::kFile;
    if (!checkbox(context, "shot.looks", "Looks of the file", of_file,
                  "The outside as the model file says; off: as the material"))
        return;
    context.shot.looks = of_file ? LooksOf::kFile : LooksOf::kMaterial;
    context.changed = true;
}

}  // namespace

void showImportPanel(PanelContext& context) {
    const int flags = context.state.show_report ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    if (context.state.open_report) ImGui::SetNextItemOpen(true);
    context.state.open_report = false;
    context.state.show_report = ImGui::CollapsingHeader("Model file", flags);
    noteItem(context, "import");
    if (!context.state.show_report) return;
    showUnit(context);
    showRepair(context);
    if (context.status.looks != nullptr) showLooks(context);
    for (const auto& [label, text] : context.report) valueRow(label.c_str(), "%s", text.c_str());
}

}  // namespace demolish
