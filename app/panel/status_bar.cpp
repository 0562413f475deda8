// SPDX-License-Identifier: Apache-2.0
// One line at the bottom: how fast, how many, where, and the last message.
#include <imgui.h>

#include "app/panel/widgets.h"

namespace demolish {

void showStatusBar(PanelContext& context) {
    const SessionStatus& status = context.status;
    const FrameSummary summary = summarise(context.history.samples());
    ImGui::Text("%.0f FPS  %.1f ms", summary.fps_median,
                summary.fps_median > 0 ? 1000 / summary.fps_median : 0);
    ImGui::SameLine(0, 24);
    ImGui::Text("%u particles  %u bonds  %u %s", status.stats.particles,
                status.stats.bonds - status.stats.bonds_broken, status.stats.fragments,
                status.stats.fragments == 1 ? "fragment" : "fragments");
    ImGui::SameLine(0, 24);
    ImGui::Text("%s, %s", status.device.c_str(), status.transfer.c_str());
    ImGui::SameLine(0, 24);
    if (!status.message.empty())
        ImGui::TextColored(ImVec4(1.0f, 0.55f, 0.40f, 1), "%s", status.message.c_str());
    else if (status.frame_share && status.playing)
        ImGui::Text("frame at %.0f %%", 100 * *status.frame_share);
    else if (status.replaying)
        ImGui::TextDisabled("showing the recording");
    else
        ImGui::TextDisabled("? shows the keys");
}

}  // namespace demolish
