// SPDX-License-Identifier: Apache-2.0
// Frame 0 shows the whole body; every further frame is one simulated frame later.
#include "app/commands/capture_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands/frame_exposure.h"
#include "app/commands/frame_files.h"
#include "app/commands/headless_stage.h"
#include "app/commands/help_text.h"
#include "app/commands/interrupt.h"
#include "app/commands/tell_refusal.h"
#include "app/commands/timed_loop.h"
#include "app/session/picture.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kFrameRange{1, 100000};
constexpr Range kMomentRange{0, 1000};                         // s
constexpr Range kYawRange{-360, 360}, kPitchRange{-180, 180};  // degrees
constexpr double kLargestVideoRate = 60;  // frames of faster shots play at this rate: slow motion

struct Capture {
    const CaptureOptions& options;
    PictureSize size;
    std::vector<uint64_t> moments;  ///< frames to draw, ascending
    std::vector<FrameSample> samples{};
    StepStatus status = StepStatus::kOk;
};

FrameFilesOptions filesFor(const Capture& capture, const Shot& shot) {
    FrameFilesOptions files;
    if (!capture.options.out.empty()) files.folder = capture.options.out;
    if (!capture.options.video.empty()) files.video = capture.options.video;
    files.frames = capture.moments.size() * capture.options.camera_yaw.size();
    if (!capture.options.at.empty())
        files.sheet_columns = static_cast<int>(std::min<size_t>(4, capture.moments.size()));
    files.width = capture.size.width;
    files.height = capture.size.height;
    files.alpha = capture.options.film.transparent;
    files.note = colourNote(shot, files.alpha);
    files.video_fps = std::min(shot.fps, kLargestVideoRate);
    return files;
}

/// The frames that are drawn: those nearest to the moments asked for, or all.
std::vector<uint64_t> momentsOf(const CaptureOptions& options, const Shot& shot) {
    std::vector<uint64_t> moments;
    for (uint64_t frame = 0; options.at.empty() && frame < static_cast<uint64_t>(options.frames); ++frame)
        moments.push_back(frame);
    for (const double at : options.at) {
        requireInRange("--at", at, kMomentRange, "s");
        moments.push_back(static_cast<uint64_t>(std::llround(at * shot.fps / shot.time_scale)));
        if (moments.size() > 1 && moments.back() <= moments[moments.size() - 2])
            throw UsageError("--at names moments in order of time, a frame apart at least");
    }
    return moments;
}

/// What particles are coloured by: their fragment, unless the view is named after something else.
ParticleColour colourOf(const std::string& view) {
    if (view == "damage") return ParticleColour::kDamage;
    if (view == "stress") return ParticleColour::kStress;
    if (view == "speed") return ParticleColour::kSpeed;
    return ParticleColour::kFragment;
}

engine::FrameView viewFor(const Capture& capture, const BuiltShot& built, bool software) {
    engine::FrameView view =
        makeFrameView(built.shot, built.cells.of_body, capture.size.width, capture.size.height,
                      renderQuality(capture.options.shot, software));
    if (capture.options.view != "surface") view.mode = engine::ViewMode::kParticles;
    view.transparent = capture.options.film.transparent;
    view.colour_map = static_cast<engine::ColourMap>(colourOf(capture.options.view));
    return view;
}

/// With the shot's camera at that time, turned, and with what hangs where it is then.
engine::FrameView viewAt(engine::FrameView view, const Capture& capture, const BuiltShot& built, double yaw,
                         double time) {
    view.camera = shotCamera(built.shot, built.cells.of_body, time);
    view.camera.orbit(static_cast<float>(glm::radians(yaw)),
                      static_cast<float>(glm::radians(capture.options.camera_pitch)));
    hangCables(built.shot, time, view);
    return view;
}

/// Draws and simulates all frames; stops at the first bad status, or when asked to, with what was drawn so
/// far.
void runFrames(Capture& capture, Session& session, HeadlessStage& stage, FrameFiles& files) {
    engine::FrameView view = viewFor(capture, session.built(), stage.info().software);
    const std::vector<double>& yaws = capture.options.camera_yaw;
    engine::FrameCapture target(
        capture.size.width, capture.size.height,
        [&](uint64_t frame, engine::Image image) { files.add(frame, std::move(image)); });
    constexpr const char* kLabel = "breaking and drawing";
    ProgressBar bar;
    TriangleCounter triangles;
    const uint64_t frames = capture.moments.back() + 1;
    FrameExposure exposure(stage.renderer());
    const engine::Lens& lens = session.shot().lens;
    size_t drawn = 0;
    for (uint64_t frame = 0; frame < frames; ++frame) {
        const StopWatch watch;
        if (frame > 0 && InterruptWatch::asked()) break;
        const double time_before = session.status().stats.time;
        if (frame == capture.moments[drawn]) exposure.remember(session, lens);
        if (frame > 0) capture.status = session.advance(watchFrame(bar, frame, frames, kLabel));
        if (capture.status != StepStatus::kOk || session.frameUnderWay()) break;
        if (frame == capture.moments[drawn]) {
            const double time = session.status().stats.time;
            for (size_t k = 0; k < yaws.size(); ++k) {
                const engine::FrameView before = viewAt(view, capture, session.built(), yaws[k], time_before);
                view = viewAt(view, capture, session.built(), yaws[k], time);
                exposure.draw(session, view, before, time - time_before, lens, target.framebuffer());
                tellRefusal(stage.renderer());
                target.submit(k * capture.moments.size() + drawn);
            }
            ++drawn;
        }
        if (frame > 0)
            capture.samples.push_back(
                sampleOf(session, triangles, watch.milliseconds(), stage.renderer().lastDrawMs()));
        bar.show(static_cast<double>(frame + 1) / static_cast<double>(frames), kLabel);
    }
    target.finish();
}

void runCapture(const CaptureOptions& options) {
    Shot shot = makeShot(options.shot);
    applyFilm(options.film, options.shot.picture.look, shot);
    requireInRange("--frames", options.frames, kFrameRange, "");
    for (const double yaw : options.camera_yaw) requireInRange("--camera-yaw", yaw, kYawRange, "degrees");
    requireInRange("--camera-pitch", options.camera_pitch, kPitchRange, "degrees");
    if (options.out.empty() && options.video.empty() && !options.files.any())
        throw UsageError("nothing to write: give --out DIR, --video FILE or --report FILE.json");
    if (!options.video.empty() && options.film.transparent)
        throw UsageError("a film has no alpha: leave out --transparent, or --video");
    if (!options.video.empty() && options.camera_yaw.size() > 1)
        throw UsageError("a film has one camera: give --camera-yaw one angle, or leave out --video");
    const bool on_gpu = choosesCuda(shot);
    Capture capture{options,
                    pictureSize(options.shot, on_gpu ? PictureSize{1920, 1080} : PictureSize{960, 540}),
                    momentsOf(options, shot)};
    FrameFiles files(filesFor(capture, shot));  // makes the folder that the report may lie in
    requireWritable(options.files);
    const InterruptWatch interrupts;
    const StopWatch watch;
    BuiltShot built = buildWithBar(shot, {});
    announce(built);
    HeadlessStage stage(on_gpu);
    Session session(std::move(built), {.draw = true});
    session.setColour(colourOf(options.view));
    runFrames(capture, session, stage, files);
    files.finish();
    if (capture.status == StepStatus::kOk) tellMessage(session);

    session.solver().measure();
    RunReport report;
    report.gl_renderer = stage.info().renderer;
    report.gl_version = stage.info().version;
    report.quality = qualityName(renderQuality(options.shot, stage.info().software));
    report.transfer = session.transfer();
    report.transfer_note = session.status().transfer_note;
    report.width = static_cast<uint32_t>(capture.size.width);
    report.height = static_cast<uint32_t>(capture.size.height);
    report.frames = capture.samples.size() + 1;
    report.wall_seconds = watch.milliseconds() / 1000;
    report.times = summarise(capture.samples);
    report.energy = session.energy();
    std::fputs(reportTable(session.built(), report).c_str(), stdout);
    FinishedRun finished{session.built(), report, capture.samples};
    LastFiles last;
    writeRunFiles(options.files, finished, last);
    last.requireAllWritten();
    requireOk(capture.status);
    const uint64_t wanted = capture.moments.back() + 1;
    if (report.frames < wanted)
        throw Interrupted("interrupted after frame " + std::to_string(report.frames) + " of " +
                          std::to_string(wanted) + "; what was made until then is whole");
}

}  // namespace

void addCaptureCommand(CLI::App& app, CaptureOptions& options) {
    auto* command = app.add_subcommand("capture", "Break a model without a window: PNG frames, film, report");
    addShotOptions(*command, options.shot);
    addFilmOptions(*command, options.film);
    auto* frames = command->add_option("--frames", options.frames, "Frames to draw")
                       ->type_name("N")
                       ->capture_default_str();
    command->add_option("--out", options.out, "Folder for frame_0000.png ... and contact_sheet.png")
        ->type_name("DIR");
    command->add_option("--video", options.video, "Film, through the ffmpeg program")->type_name("FILE");
    addRunFileOptions(*command, options.files);
    command
        ->add_option("--view", options.view,
                     "What to draw; the last three: particles by share of broken bonds, by bond stress over "
                     "strength, by speed")
        ->type_name("surface|particles|damage|stress|speed")
        ->check(CLI::IsMember({"surface", "particles", "damage", "stress", "speed"}).description(""))
        ->capture_default_str();
    command->add_option("--at", options.at, "Draw these moments only, in seconds; instead of --frames")
        ->type_name("S,S,...")
        ->delimiter(',')
        ->excludes(frames)
        ->allow_extra_args(false);
    command
        ->add_option("--camera-yaw", options.camera_yaw,
                     "Turn the camera round the body, 180 = from behind; several angles: several cameras")
        ->type_name("DEGREES,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--camera-pitch", options.camera_pitch, "Raise the camera over the body")
        ->type_name("DEGREES");
    setExamples(*command, {"capture bunny --out out/bunny --video out/bunny/bunny.mp4",
                           "capture wolf --at 0.3,1.2,1.42,4.5 --camera-yaw 0,-60 --out out/wolf",
                           "capture --model statue.obj --drop 5 --view damage --out out/statue"});
    command->callback([&options] { runCapture(options); });
}

}  // namespace demolish
