// SPDX-License-Identifier: Apache-2.0
// Step status in words: what happened, and which knob to turn.
#include "sim_cuda/api/stats.h"

namespace demolish {

std::string describe(StepStatus status) {
    if (status == StepStatus::kOk) return "ok";
    std::string text;
    const auto add = [&](StepStatus bit, const char* sentence) {
        if (!has(status, bit)) return;
        if (!text.empty()) text += " ";
        text += sentence;
    };
    add(StepStatus::kNotFinite,
        "The simulation became unstable; lower the impact velocity or raise the substeps.");
    add(StepStatus::kLeftScene,
        "Something flew out of the scene; lower the impact velocity or raise scene_radius_m in the scene "
        "file.");
    return text;
}

}  // namespace demolish
