// SPDX-License-Identifier: Apache-2.0
// What the window shows besides the running shot: the chosen scene, camera and view settings, and what the
// panels say. Plain values; no GPU state.
#pragma once
#include <string>
#include <vector>

#include "app/calibrate/calibration_worker.h"
#include "app/panel/camera_control.h"
#include "app/panel/gizmo.h"
#include "app/panel/panel_context.h"
#include "app/panel/shortcuts.h"

namespace demolish {

struct ViewDesk {
    Shot preset;  ///< as loaded
    ViewSettings view;
    PanelState panels;
    ItemRegistry items;
    FrameHistory history;
    engine::Camera camera;
    CameraControl mouse;
    CameraHome home;
    std::vector<std::string> scenes, materials;
    std::string gl_renderer;
    unsigned colour_ramp = 0;  ///< GL texture, as PanelContext
    std::string message;       ///< what a load said; "" if it went well
    PictureArea picture;
    ThresholdView threshold;
    DevicePace pace;  ///< of the device that the shot runs on

    ViewDesk(const Session& session, const Shot& preset_shot);

    /// Shows panels, reads keys and mouse; returns what the session is to do. `click` gets a click into the
    /// picture.
    std::vector<command::Any> update(const Session& session, std::optional<PicturePoint>& click);
    /// Camera and framing for a body that is new, and no times of frames of the one before.
    void adoptBody(const Session& session, bool move_camera);
    /// The shot's camera is where it is at the time on screen, and the window's with it, until somebody moves
    /// that; key 0 brings it back.
    void followShot(const Session& session);
    /// Loads a scene or mesh into a shot; the message tells what went wrong.
    std::optional<Shot> load(const std::string& scene, const std::string& model, const Shot& present);
    engine::FrameView frameView(const Session& session) const;

  private:
    void followReport(const Session& session);
    void takeMaterials(const Session& session, PanelContext& context);
    void followThreshold(const Session& session);
    std::optional<Calibration> takeMeasurement();
    void obeyThreshold(const PanelContext& context, const Session& session);

    bool follows_shot_ = true;
    LabelledLines report_;  ///< of `reported_`
    std::shared_ptr<const BreakableBody> reported_;
    Gizmo gizmo_;
    CalibrationWorker calibration_;
    Shot built_preset_;  ///< of what is on screen; `preset` runs ahead of it while that is made
    std::optional<Shot> threshold_shot_;  ///< that `threshold` speaks of
    std::shared_ptr<const BreakableBody> threshold_body_;
};

}  // namespace demolish
