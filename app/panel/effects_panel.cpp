// SPDX-License-Identifier: Apache-2.0
// Grit, dust and sparks: whether there are any, and how much. Acts on what breaks from now on.
#include <imgui.h>

#include "app/panel/widgets.h"

namespace demolish {

void showEffectsPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Grit, dust and sparks", ImGuiTreeNodeFlags_DefaultOpen)) return;
    EffectsSettings& effects = context.shot.effects;
    const EffectsSettings& preset = context.preset.effects;
    context.changed |= checkbox(context, "effects.on", "Show", effects.on,
                                "Grit and dust where bodies break. The pieces move the same without");
    if (!effects.on) return;
    ImGui::SameLine();
    context.changed |= checkbox(context, "effects.crumbling", "Crumble", effects.crumbling,
                                "Single cells are drawn in all sizes, and lose crumbs");
    const SliderScale amount{0, 10};
    context.changed |= slider(context, {"effects.grit", "Grit", "%.2f x", "Times what the material says."},
                              effects.grit, amount, preset.grit);
    context.changed |= slider(context, {"effects.dust", "Dust", "%.2f x", "Times what the material says."},
                              effects.dust, amount, preset.dust);
    context.changed |= slider(
        context,
        {"effects.sparks", "Sparks", "%.2f x", "Where an iron ball hits hard; times what the material says."},
        effects.sparks, amount, preset.sparks);
}

}  // namespace demolish
