// SPDX-License-Identifier: Apache-2.0
// Material preset and its knobs. A change makes a new solver on the same cells.
#include <imgui.h>

#include <cmath>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

bool showStrength(PanelContext& context) {
    Material& material = context.shot.material;
    const Material& preset = context.preset.material;
    bool changed =
        slider(context,
               {"material.critical_velocity", "Critical velocity", "%.2f m/s",
                "Strength: a ball of this material breaks when dropped this fast. Higher is stronger."},
               material.critical_velocity, {0.2, 50, true}, preset.critical_velocity);
    if (changed) context.shot.break_at.reset();
    double cells = material.tough_cells;
    if (slider(context,
               {"material.tough_cells", "Tough cells", "%.0f",
                "Number of pieces that the body prefers to break into; 0: no preference."},
               cells, {0, 300}, preset.tough_cells)) {
        material.tough_cells = static_cast<uint32_t>(std::lround(cells));
        changed = true;
    }
    changed |= slider(context, {"material.density", "Density", "%.0f kg/m3", "Bulk density."},
                      material.density, {100, 12000, true}, preset.density);
    return changed;
}

bool showContact(PanelContext& context) {
    Material& material = context.shot.material;
    const Material& preset = context.preset.material;
    bool changed =
        slider(context, {"material.friction", "Friction", "%.2f", "Coulomb's mu between pieces and floor."},
               material.friction, {0, 1.5}, preset.friction);
    changed |=
        slider(context, {"material.restitution", "Restitution", "%.2f", "Bounce: rebound over impact speed."},
               material.restitution, {0.05, 0.95}, preset.restitution);
    changed |= slider(context,
                      {"material.damping", "Damping ratio", "%.2f",
                       "Of the bonds' highest mode; more damps stress waves and makes fewer pieces."},
                      material.damping_ratio, {0.05, 0.6}, preset.damping_ratio);
    changed |= slider(context,
                      {"material.tough_factor", "Toughness inside cells", "%.1f x",
                       "Strength of bonds inside a tough cell over that of bonds between cells."},
                      material.tough_factor, {1, 10}, preset.tough_factor);
    changed |= slider(context,
                      {"material.weibull", "Weibull modulus", "%.1f",
                       "Scatter of bond strengths: 3 scatters widely, 15 hardly; 0 is off."},
                      material.weibull_modulus, {0, 30}, preset.weibull_modulus);
    return changed;
}

void showInside(PanelContext& context) {
    if (context.shot.look.isTransparent()) return;
    constexpr const char* kOwn = "its own";
    std::vector<std::string> names{kOwn};
    names.insert(names.end(), context.materials.begin(), context.materials.end());
    const std::string& present = context.shot.inner_material;
    const int chosen =
        combo(context, "material.inner", "Inside that breaks show", names, present.empty() ? kOwn : present,
              "Colour, roughness and pattern of another material; strength stays as it is");
    if (chosen < 0) return;
    context.shot.inner_material = chosen == 0 ? "" : names[static_cast<size_t>(chosen)];
    context.changed = true;
}

}  // namespace

void showMaterialPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Material", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const int chosen =
        combo(context, "material.preset", "Preset", context.materials, context.shot.material_name,
              "Strength, density, friction and colours of a material");
    if (chosen >= 0) {
        context.shot.material_name = context.materials[static_cast<size_t>(chosen)];
        context.changed = true;
    }
    showInside(context);
    context.changed |= showStrength(context);
    if (context.state.advanced) context.changed |= showContact(context);
    const SofteningReport& softening = context.status.softening;
    ImGui::TextDisabled("Softened: E = %.3g MPa of %.3g GPa,", softening.effective_modulus / 1e6,
                        context.shot.material.youngs_modulus / 1e9);
    ImGui::TextDisabled("breaks at %.3g MPa of %.3g MPa, strain %.2f %%", softening.strength / 1e6,
                        context.shot.material.tensile_strength / 1e6, 100 * softening.strain_at_failure);
    tooltipOnHover(
        "In force, of the real material's. The time step allows only a softer body than the real one. Its "
        "strength is chosen so that the impact velocity means the same.");
}

}  // namespace demolish
