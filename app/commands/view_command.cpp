// SPDX-License-Identifier: Apache-2.0
// The window's loop: input, panels, commands, step, draw.
#include "app/commands/view_command.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>

#include "app/commands/help_text.h"
#include "app/commands/picture_target.h"
#include "app/commands/session_json.h"
#include "app/commands/still_picture.h"
#include "app/commands/tell_refusal.h"
#include "app/commands/timed_loop.h"
#include "app/commands/view_desk.h"
#include "app/panel/gui.h"
#include "app/panel/script_driver.h"
#include "app/session/data_folder.h"
#include "app/session/output_file.h"
#include "engine/platform/window.h"
#include "engine/render/colour_ramp.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A frame is due when real time has caught up with simulated time.
class Pace {
  public:
    bool due(double now, double fps, bool real_time) {
        if (!real_time) return true;
        if (now < next_) return false;
        next_ = std::max(next_ + 1 / fps, now - 0.1);  // no burst after a hitch
        return true;
    }

  private:
    double next_ = 0;
};

void requireDisplay() {
    std::string reason;
    if (!engine::Window::available(&reason))
        throw DeviceError("no window can be opened (" + reason +
                          "); without a display use: demolish capture bunny --out out/bunny");
}

/// The point under the cursor, shot at from the eye.
command::Any shootAt(engine::Renderer& renderer, const Session& session, const engine::FrameView& view,
                     PicturePoint point) {
    const engine::Pick pick = renderer.pick(session.mesh(), session.spheres(), view, point.x, point.y);
    glm::vec3 target(pick.position[0], pick.position[1], pick.position[2]);
    if (!pick.hit) {
        const engine::Ray ray = engine::pixelRay(view.camera, view.width, view.height,
                                                 static_cast<float>(point.x), static_cast<float>(point.y));
        target = ray.origin + glm::length(view.camera.target - view.camera.eye) * ray.direction;
    }
    const glm::vec3 eye = view.camera.eye;
    return command::ShootAt{{eye.x, eye.y, eye.z}, {target.x, target.y, target.z}};
}

/// Asks for a rebuilt body's camera only when the model is another one.
void followBody(ViewDesk& desk, const Session& session, std::filesystem::path& model,
                std::shared_ptr<const BreakableBody>& body) {
    if (session.built().body == body) return;
    desk.adoptBody(session, session.built().shot.model != model);
    body = session.built().body;
    model = session.built().shot.model;
}

/// The turn of the window ends before the simulated frame does.
bool withinFrame(const Session& session) {
    return session.playing() && session.frameUnderWay();
}

struct ViewLoop {
    engine::Window& window;
    engine::Renderer& renderer;
    Session& session;
    ViewDesk& desk;
    Gui& gui;
    ScriptDriver* script;
    StillPicture still{renderer};
    PictureTarget target{};
    TriangleCounter triangles{};
    Pace pace{};
    std::filesystem::path model{};
    std::shared_ptr<const BreakableBody> body{};
    std::string dropped{};
    double turns_ms = 0;  ///< of a frame that takes several turns, so far

    void frame() {
        const StopWatch watch;
        window.pollEvents();
        gui.beginFrame([this] {
            if (script != nullptr) script->inject(desk.items, desk.picture);
        });
        std::optional<PicturePoint> click;
        std::vector<command::Any> commands = desk.update(session, click);
        if (!dropped.empty())
            if (auto shot = desk.load("", std::exchange(dropped, {}), session.shot()))
                commands.emplace_back(command::ChangeShot{*shot});
        const double now = secondsNow();
        if (click) commands.push_back(shootAt(renderer, session, desk.frameView(session), *click));
        for (const auto& command : commands) session.apply(command, now);
        session.setColour(static_cast<ParticleColour>(desk.view.colour_map));
        session.update(now, pace.due(now, session.shot().fps, desk.view.real_time));
        followBody(desk, session, model, body);
        desk.followShot(session);
        draw();
        if (script != nullptr) script->afterDraw();
        window.swapBuffers();
        turns_ms += watch.milliseconds();
        if (!withinFrame(session))
            desk.history.add(sampleOf(session, triangles, std::exchange(turns_ms, 0), renderer.lastDrawMs()));
    }

    void draw() {
        const engine::FrameView view = desk.frameView(session);
        still.draw(session.mesh(), session.spheres(), view, session.shot().lens, session.playing(),
                   target.framebuffer(view.width, view.height));
        tellRefusal(renderer);
        target.copyToWindow(desk.picture, window.framebufferHeight());
        gui.endFrame();
    }
};

ScriptHooks hooksFor(engine::Window& window, Session& session, const ViewDesk& desk) {
    ScriptHooks hooks;
    hooks.conditions["rebuilt"] = [&session] {
        const SessionStatus status = session.status();
        return !status.waiting && !status.rebuilding;
    };
    hooks.conditions["building"] = [&session] { return session.status().rebuilding; };
    hooks.conditions["within_frame"] = [&session] { return withinFrame(session); };
    hooks.conditions["measuring"] = [&desk] { return desk.threshold.measuring; };
    hooks.conditions["measured"] = [&desk] { return !desk.threshold.measuring; };
    hooks.screenshot = [&window](const std::filesystem::path& file) {
        saveWindow(file, window.framebufferWidth(), window.framebufferHeight());
    };
    hooks.state = [&session](const std::filesystem::path& file) {
        writeTextFile(file, sessionJson(session));
    };
    return hooks;
}

void runView(const ViewOptions& options) {
    const Shot shot = makeShot(options.shot);
    const PictureSize size = pictureSize(options.shot, {1600, 900});
    requireDisplay();
    BuiltShot built = buildWithBar(shot, {.ledger = false});
    announce(built);
    engine::Window window(
        {.title = "Demolish", .width = size.width, .height = size.height, .vsync = !options.no_vsync});
    if (!window.info().note.empty()) spdlog::warn("{}", window.info().note);
    engine::Renderer renderer(dataFolder() / "shaders");
    Session session(std::move(built), {.draw = true, .record = true});
    ViewDesk desk(session, shot);
    const engine::ColourRamp colour_ramp(dataFolder() / "shaders");
    desk.colour_ramp = colour_ramp.texture().id();
    desk.pace = measurePace(session.solver().onGpu(), session.status().stats.particles);
    desk.gl_renderer = window.info().renderer;
    desk.view.quality = renderQuality(options.shot, window.info().software);
    desk.view.samples = windowSamples(window.info().software);
    std::unique_ptr<ScriptDriver> script;
    if (!options.script.empty())
        script = std::make_unique<ScriptDriver>(options.script, hooksFor(window, session, desk));

    Gui gui(window.handle(), window.contentScale());
    ViewLoop loop{window, renderer, session, desk, gui, script.get()};
    engine::WindowEvents events;
    events.on_drop = [&loop](const engine::DropEvent& drop) {
        if (!drop.paths.empty()) loop.dropped = drop.paths.front();
    };
    window.setEvents(std::move(events));
    session.apply(command::Play{}, secondsNow());
    while (!window.shouldClose() && !(script && script->finished())) loop.frame();
}

}  // namespace

void addViewCommand(CLI::App& app, ViewOptions& options) {
    auto* command = app.add_subcommand("view", "Break a model in a window");
    command->add_option("--script", options.script)->group("");  // of the window tests
    addShotOptions(*command, options.shot);
    command->add_flag("--no-vsync", options.no_vsync, "Do not wait for the screen");
    setExamples(*command, {"view vase --material glass", "view --model statue.obj --height 2 --drop 5"});
    command->callback([&options] { runView(options); });
}

}  // namespace demolish
