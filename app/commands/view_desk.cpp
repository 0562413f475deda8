// SPDX-License-Identifier: Apache-2.0
// Panels in, commands out.
#include "app/commands/view_desk.h"

#include <cmath>
#include <utility>

#include "app/commands/one_sentence.h"
#include "app/session/data_folder.h"
#include "app/session/model_shot.h"
#include "app/session/picture.h"
#include "app/session/scene_file.h"
#include "app/session/shot_setup.h"

namespace demolish {

ViewDesk::ViewDesk(const Session& session, const Shot& preset_shot)
    : preset(preset_shot), scenes(assetNames("scenes")), materials(assetNames("materials")) {
    adoptBody(session, true);
}

void ViewDesk::adoptBody(const Session& session, bool move_camera) {
    const Shot& shot = session.built().shot;
    history = FrameHistory();
    if (sameSubject(preset, shot)) {
        if (std::exchange(preset.impact.times_threshold, std::nullopt))
            preset.impact.velocity = shot.impact.velocity;
        built_preset_ = preset;
    }
    const SceneBox box = sceneBox(shot, session.built().cells.of_body);
    const glm::vec3 low(box.low.x, box.low.y, box.low.z), high(box.high.x, box.high.y, box.high.z);
    home.centre = 0.5f * (low + high);
    home.radius = 0.6f * glm::length(high - low);
    follows_shot_ = follows_shot_ || move_camera;
    followShot(session);
}

void ViewDesk::followShot(const Session& session) {
    const BuiltShot& built = session.built();
    home.shot_camera = shotCamera(built.shot, built.cells.of_body, session.status().stats.time);
    if (follows_shot_) camera = home.shot_camera;
}

std::optional<Shot> ViewDesk::load(const std::string& scene, const std::string& model, const Shot& present) {
    try {
        if (isEnvironmentFile(model)) {
            Shot lit = present;
            setEnvironment(lit.environment, model);
            litBy(lit.environment, lit.lighting);  // a bad file is told here
            message.clear();
            return lit;
        }
        Shot shot;
        const bool is_scene_file = std::filesystem::path(model).extension() == ".toml";
        if (!scene.empty() || is_scene_file) {
            shot = loadScene(is_scene_file ? model : scene);
        } else {
            shot = modelShot(model, present.material_name);
            panels.open_report = true;
        }
        shot.device = present.device;
        preset = shot;
        panels.chosen_body.reset();
        message.clear();
        return shot;
    } catch (const std::exception& error) {
        message = error.what();
        return std::nullopt;
    }
}

/// What has just come in, if anything.
std::optional<Calibration> ViewDesk::takeMeasurement() {
    threshold.measuring = calibration_.busy();
    threshold.fraction = calibration_.fraction();
    try {
        return calibration_.take();
    } catch (const std::exception& error) {
        message = error.what();
        return std::nullopt;
    }
}

void ViewDesk::followThreshold(const Session& session) {
    const auto& body = session.built().body;
    if (threshold_body_ == body && threshold_shot_ &&
        changeBetween(*threshold_shot_, session.shot()) == Change::kNothing)
        return;
    threshold_shot_ = session.shot();
    threshold_body_ = body;
    threshold.value = thresholdOf(session.shot(), *body);
}

void ViewDesk::obeyThreshold(const PanelContext& context, const Session& session) {
    if (context.cancel_measuring) calibration_.cancel();
    if (!context.measure_threshold) return;
    message.clear();
    Shot shot = session.built().shot;  // the strength in force, with the impact as it is chosen now
    shot.break_at = session.shot().break_at;
    if (shot.impact.kind == session.shot().impact.kind) shot.impact = session.shot().impact;
    calibration_.start(shot, session.built().body);
}

/// Walls are measured, so only while somebody looks.
void ViewDesk::followReport(const Session& session) {
    if (!panels.show_report || reported_ == session.built().body) return;
    report_ = checkLines(checkOf(session.built()));
    reported_ = session.built().body;
}

/// Names that panels chose become materials.
void ViewDesk::takeMaterials(const Session& session, PanelContext& context) {
    Shot& shot = context.shot;
    try {
        if (shot.material_name != session.shot().material_name ||
            shot.inner_material != session.shot().inner_material)
            applyMaterials(shot, shot.material_name, shot.inner_material);
        if (!context.material_of_body || !panels.chosen_body) return;
        std::optional<OwnMaterial>& own = shot.bodies.at(*panels.chosen_body).material;
        own.reset();
        if (!context.material_of_body->empty()) own = presetMaterial(*context.material_of_body);
        context.changed = true;
    } catch (const std::exception& error) {
        message = error.what();
        context.shot = session.shot();
        context.changed = false;
    }
}

std::vector<command::Any> ViewDesk::update(const Session& session, std::optional<PicturePoint>& click) {
    std::vector<command::Any> commands;
    if (!sameSubject(preset, session.shot()))
        preset = built_preset_;  // it could not be made, or was cancelled
    const std::optional<Calibration> measured = takeMeasurement();
    if (measured) threshold_shot_.reset();
    followThreshold(session);
    SessionStatus status = session.status();
    status.message = oneSentence(status.message.empty() ? message : status.message);
    PanelContext context{session.shot(), preset, status, history,  gl_renderer, scenes, materials,
                         view,           panels, items,  commands, false,       {},     {}};
    followReport(session);
    if (panels.show_report) context.report = report_;
    context.threshold = threshold;
    context.pace = pace;
    context.colour_ramp = colour_ramp;
    if (measured && context.shot.break_at && context.shot.break_at == measured->shot.break_at) {
        context.shot.material.critical_velocity = measured->shot.material.critical_velocity;
        context.changed = true;
    }
    showPanels(context);
    handleShortcuts(context, camera, home);
    obeyThreshold(context, session);
    picture = pictureArea(panels);
    if (!gizmo_.update(context, session.built().cells.of_body, camera, picture))
        click = mouse.update(camera, picture);
    follows_shot_ = camera == home.shot_camera;
    if (panels.arrange) click.reset();

    if (!context.load_scene.empty() || !context.load_model.empty()) {
        if (auto shot = load(context.load_scene, context.load_model, session.shot()))
            commands.emplace_back(command::ChangeShot{*shot});
        return commands;
    }
    takeMaterials(session, context);
    if (context.changed) commands.emplace_back(command::ChangeShot{context.shot});
    return commands;
}

engine::FrameView ViewDesk::frameView(const Session& session) const {
    Shot shot = session.built().shot;
    shot.look = session.shot().look;
    shot.lighting = session.shot().lighting;
    shot.environment = session.shot().environment;
    shot.lens = session.shot().lens;
    engine::FrameView frame =
        makeFrameView(shot, session.built().cells.of_body, picture.width, picture.height, view.quality);
    hangCables(shot, session.status().stats.time, frame);
    frame.camera = camera;
    frame.mode = view.mode;
    frame.colour_map = view.colour_map;
    frame.show_cracks = view.show_cracks;
    frame.show_floor = view.show_floor;
    frame.samples = view.samples;
    return frame;
}

}  // namespace demolish
