// SPDX-License-Identifier: Apache-2.0
#include "app/session/model_shot.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "app/session/scene_file.h"
#include "sim_cuda/api/model_file.h"

namespace demolish {
namespace {

const std::vector<std::string> kNames{"m", "cm", "mm", "in", "ft"};
constexpr double kMetres[] = {1, 0.01, 0.001, 0.0254, 0.3048};
constexpr Range kPlausibleSize{0.00999, 100.1};  // m: 1 cm to 100 m, and what is rounded

}  // namespace

const std::vector<std::string>& lengthUnitNames() {
    return kNames;
}

std::optional<double> lengthUnitOf(const std::string& name) {
    const auto at = std::find(kNames.begin(), kNames.end(), name);
    if (at == kNames.end()) return std::nullopt;
    return kMetres[at - kNames.begin()];
}

std::string lengthUnitName(double metres) {
    const auto at = std::find(std::begin(kMetres), std::end(kMetres), metres);
    return at == std::end(kMetres) ? "" : kNames[static_cast<size_t>(at - std::begin(kMetres))];
}

bool hasKnownSize(const std::filesystem::path& model, const ModelPart& part) {
    return part.unit > 0 || saysItsUnit(model);
}

std::string refusalOfUnit(const std::filesystem::path& model) {
    if (!saysItsUnit(model)) return "";
    return "the format of '" + model.filename().string() + "' says its unit itself";
}

std::string sizeRemark(const Shot& shot, const Double3& low, const Double3& high, Advised advised) {
    if (!shot.bodies.empty()) return "";
    const std::string name = shot.model.filename().string();
    const bool in_window = advised == Advised::kWindow;
    if (!shot.keeps_size) {
        const bool is_said =
            shot.height != 1 || !shot.scene_file.empty() || hasKnownSize(shot.model, shot.part);
        if (is_said) return "";
        return name + " does not say its unit, so it is scaled to 1 m; " +
               (in_window ? "'Unit of the file' under 'Model file' keeps its size"
                          : "--unit m, cm, mm, in or ft keeps its size");
    }
    const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (longest >= kPlausibleSize.least && longest <= kPlausibleSize.most) return "";
    char size[32];
    std::snprintf(size, sizeof size, "%.3g", longest);
    const std::string unit =
        saysItsUnit(shot.model)
            ? "check the unit of its export"
            : (in_window ? "choose another 'Unit of the file' under 'Model file'" : "give another --unit");
    return name + " is " + size + " m long, which is hardly meant; " + unit + ", or scale it by " +
           (in_window ? "'Model height'" : "--height");
}

Shot modelShot(const std::filesystem::path& model, const std::string& material) {
    Shot shot;
    shot.model = model;
    shot.impact.times_threshold = kModelTimesThreshold;
    shot.keeps_size = hasKnownSize(model, shot.part);
    applyMaterial(shot, material.empty() ? shot.material_name : material);
    return shot;
}

void setUnit(Shot& shot, double unit) {
    shot.part.unit = unit;
    shot.keeps_size = hasKnownSize(shot.model, shot.part);
    shot.height = 1;
}

}  // namespace demolish
