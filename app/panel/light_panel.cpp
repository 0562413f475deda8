// SPDX-License-Identifier: Apache-2.0
// Surroundings, floor and camera.
#include <imgui.h>

#include <algorithm>

#include "app/panel/widgets.h"

namespace demolish {
namespace {

/// A value of the shot that is a float there.
bool floatSlider(PanelContext& context, const SliderText& text, float& value, const SliderScale& scale,
                 float preset) {
    double number = static_cast<double>(value);
    if (!slider(context, text, number, scale, static_cast<double>(preset))) return false;
    value = static_cast<float>(number);
    return true;
}

bool showSurroundings(PanelContext& context) {
    Environment& environment = context.shot.environment;
    std::vector<std::string> names = ownEnvironmentNames();
    if (!environment.file.empty()) names.push_back(environment.file.filename().string());
    const int chosen =
        combo(context, "light.environment", "Surroundings", names, environmentName(environment),
              "What lights the scene and is mirrored; drop an .hdr or .exr onto the window for another");
    if (chosen >= 0) environment.kind = static_cast<engine::SurroundingsKind>(chosen);
    bool changed = chosen >= 0;
    if (environment.kind == engine::SurroundingsKind::kFile)
        changed |=
            slider(context, {"light.turn", "Turn", "%.0f deg", "Turns the picture about the vertical."},
                   environment.turn, {-180, 180}, context.preset.environment.turn);
    if (environment.kind != engine::SurroundingsKind::kSky) return changed;
    bool by_hour = environment.hour.has_value();
    if (checkbox(context, "light.by_hour", "Sun by the hour", by_hour, "Instead of where the scene has it")) {
        environment.hour = by_hour ? std::optional<double>(12) : std::nullopt;
        changed = true;
    }
    if (environment.hour)
        changed |=
            slider(context, {"light.hour", "Hour", "%.1f h", "From sunrise to sunset."}, *environment.hour,
                   {kHourRange.least, kHourRange.most}, context.preset.environment.hour.value_or(12));
    return changed;
}

bool showCamera(PanelContext& context) {
    engine::Lighting& light = context.shot.lighting;
    const engine::Lighting& preset = context.preset.lighting;
    bool changed =
        floatSlider(context, {"light.exposure", "Exposure", "%.2f x", "Brightness of the picture."},
                    light.exposure, {0.1, 5, true}, preset.exposure);
    if (!context.state.advanced) return changed;
    const int tone =
        combo(context, "light.tone", "Tone curve", toneNames(), toneNames()[static_cast<size_t>(light.tone)],
              "From light to display: film has contrast, agx is softer, neutral keeps colours");
    if (tone >= 0) light.tone = static_cast<engine::ToneCurve>(tone);
    changed |= tone >= 0;
    changed |= floatSlider(context,
                           {"light.white_balance", "White balance", "%.0f K",
                            "Colour temperature of the light that is shown as white."},
                           light.temperature, {2000, 12000, true}, preset.temperature);
    engine::Lens& lens = context.shot.lens;
    bool pinhole = lens.aperture <= 0;
    if (checkbox(context, "light.pinhole", "Sharp everywhere", pinhole,
                 "Off: a lens, whose blur shows while paused")) {
        lens.aperture = pinhole ? 0.0f : 4.0f;
        changed = true;
    }
    if (!pinhole)
        changed |= floatSlider(
            context, {"light.aperture", "Aperture", "F %.1f", "Of a full-frame lens; less blurs more."},
            lens.aperture, {1, 22, true}, std::max(1.0f, context.preset.lens.aperture));
    return changed;
}

}  // namespace

void showLightPanel(PanelContext& context) {
    if (!ImGui::CollapsingHeader("Light")) return;  // the panels below it stay in sight
    context.changed |= showSurroundings(context);
    engine::FloorMaterial& floor = context.shot.lighting.floor;
    const int chosen =
        combo(context, "light.floor", "Floor", floorNames(), floorNames()[static_cast<size_t>(floor)],
              "What it is made of; shadow: only the shadows on it are seen");
    if (chosen >= 0) floor = static_cast<engine::FloorMaterial>(chosen);
    context.changed |= chosen >= 0;
    context.changed |= showCamera(context);
}

}  // namespace demolish
