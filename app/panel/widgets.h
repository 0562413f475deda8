// SPDX-License-Identifier: Apache-2.0
// Thin layer over Dear ImGui's controls: label above, unit in the value, tooltip, limits that hold, reset by
// right click.
#pragma once
#include "app/panel/panel_context.h"

namespace demolish {

struct SliderText {
    const char* id;  ///< name in the registry, unique
    const char* label;
    const char* format;   ///< printf, with the unit: "%.1f m/s"
    const char* tooltip;  ///< meaning, range, cost
};
struct SliderScale {
    double least, most;
    bool logarithmic = false;
    double shown_per_unit = 1;  ///< 1000: SI metres shown as millimetres
};

/// Edits an SI value. True when it changed. Ctrl-click types a number; limits hold there too. `preset` is
/// what a right click resets to; a star marks values that differ from it.
bool slider(PanelContext& context, const SliderText& text, double& value, const SliderScale& scale,
            double preset);

bool button(PanelContext& context, const char* id, const char* label, const char* tooltip,
            bool enabled = true);
bool checkbox(PanelContext& context, const char* id, const char* label, bool& value, const char* tooltip);
/// Index of the chosen name, or -1 when nothing was chosen in this frame.
int combo(PanelContext& context, const char* id, const char* label, const std::vector<std::string>& names,
          const std::string& current, const char* tooltip);

/// Registers the item that was just made.
void noteItem(PanelContext& context, const char* id);
/// Of the item that was just made; not after a click on it.
void tooltipOnHover(const char* text);
/// A row "label    value" in small type; what is too long goes on in the next line.
void valueRow(const char* label, const char* format, ...) __attribute__((format(printf, 2, 3)));

}  // namespace demolish
