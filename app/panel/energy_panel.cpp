// SPDX-License-Identifier: Apache-2.0
// The energy ledger of the shot. Closed by default: only while it is open is energy booked in every substep,
// and measured in every frame.
#include <imgui.h>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

void showLedger(const EnergyBalance& balance) {
    const EnergyLedger& energy = balance.now;
    const double in = balance.broughtIn();
    const auto row = [in](const char* label, double joules) {
        if (in > 0)
            valueRow(label, "%.3g J, %.1f %%", joules, 100 * joules / in);
        else
            valueRow(label, "%.3g J", joules);
    };
    valueRow("Brought in", "%.4g J", in);
    tooltipOnHover("Motion at the start, shots fired since, height lost.");
    row("Motion", energy.kinetic);
    row("Elastic", energy.elastic);
    row("Height gained", energy.potential - balance.start.potential);
    row("Damping", energy.damping - balance.start.damping);
    row("Friction", energy.friction - balance.start.friction);
    row("Fracture", energy.fracture - balance.start.fracture);
    if (balance.since > 0) {
        ImGui::TextDisabled("Booked since %.2f s", balance.since);
        tooltipOnHover("Energy is booked only while this is open. Reset to see the whole shot.");
    }
    valueRow("Found again", "%.2f %%", 100 * balance.closure());
    tooltipOnHover("All of it together over what was brought in: 100 to 105 % when the step is fine enough.");
}

}  // namespace

void showEnergyPanel(PanelContext& context) {
    const bool open = ImGui::CollapsingHeader("Energy");
    noteItem(context, "energy.header");
    tooltipOnHover("Where the energy of the impact went. Booked while this is open.");
    if (open != context.status.measuring) context.commands.emplace_back(command::MeasureEnergy{open});
    if (!open) return;
    if (context.status.energy)
        showLedger(*context.status.energy);
    else
        ImGui::TextDisabled("of the newest frame only");
}

}  // namespace demolish
