// SPDX-License-Identifier: Apache-2.0
// What the panels see in one frame: values to show, values to edit, commands to give. Panels own nothing
// else.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/panel/item_registry.h"
#include "app/session/commands.h"
#include "app/session/frame_times.h"
#include "app/session/model_check.h"
#include "app/session/session.h"
#include "app/session/shot_cost.h"
#include "app/session/threshold.h"
#include "engine/scene/frame_view.h"

namespace demolish {

/// How the picture is shown; nothing that the simulation depends on.
struct ViewSettings {
    engine::ViewMode mode = engine::ViewMode::kSurface;
    engine::ColourMap colour_map = engine::ColourMap::kFragment;
    engine::RenderQuality quality = engine::RenderQuality::kFull;
    bool show_cracks = true, show_floor = true;
    int samples = 4;
    bool real_time = true;  ///< never faster than real time; false: a simulated frame for every drawn one
};

/// What the window remembers about its panels.
struct PanelState {
    bool show_panels = true, show_help = false, advanced = false;
    std::string typed_model;   ///< path in the model field
    bool show_report = false;  ///< of the model file
    bool open_report = false;  ///< in the next frame, whatever it was
    bool arrange = false;      ///< clicks into the picture choose bodies
    std::optional<size_t> chosen_body;
    float statistics_height = 0;  ///< px, measured
};

/// From which velocity the shot breaks its body, and a measurement of it under way.
struct ThresholdView {
    std::optional<Threshold> value;
    bool measuring = false;
    double fraction = 0;
};

struct PanelContext {
    Shot shot;           ///< edited here; becomes a command when it differs
    const Shot& preset;  ///< as loaded: what "reset" returns to
    const SessionStatus& status;
    const FrameHistory& history;
    const std::string& gl_renderer;
    const std::vector<std::string>& scenes;
    const std::vector<std::string>& materials;
    ViewSettings& view;
    PanelState& state;
    ItemRegistry& items;
    std::vector<command::Any>& commands;
    bool changed = false;                           ///< shot was edited
    std::string load_scene;                         ///< scene to load instead, by name
    std::string load_model;                         ///< mesh file to load instead
    std::optional<std::string> material_of_body{};  ///< chosen for the body; "": as the scene
    LabelledLines report{};                         ///< what `demolish check` says; empty where not shown
    ThresholdView threshold{};
    DevicePace pace{};         ///< of the device that the shot runs on
    unsigned colour_ramp = 0;  ///< GL texture, the scale of the particle colours
    bool measure_threshold = false, cancel_measuring = false;  ///< pressed
};

void showShotPanel(PanelContext& context);
void showImportPanel(PanelContext& context);
void showBodiesPanel(PanelContext& context);
void showImpactPanel(PanelContext& context);
void showMethodPanel(PanelContext& context);
void showMaterialPanel(PanelContext& context);
void showParticlesPanel(PanelContext& context);
void showEffectsPanel(PanelContext& context);
void showViewPanel(PanelContext& context);
void showLightPanel(PanelContext& context);
void showEnergyPanel(PanelContext& context);
void showStatisticsPanel(PanelContext& context);
void showTransportBar(PanelContext& context);
void showStatusBar(PanelContext& context);
void showHelp(PanelContext& context);

}  // namespace demolish
