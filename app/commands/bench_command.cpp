// Timed frames: each one is stepped, drawn and waited for, so that a frame's time holds all its work.
#include "app/commands/bench_command.h"

#include <glad/gl.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/headless_stage.h"
#include "app/commands/run_report.h"
#include "app/commands/timed_loop.h"
#include "app/session/output_file.h"
#include "app/session/picture.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kFrameRange{1, 100000};
constexpr Range kWarmupRange{0, 100000};

/// Context, renderer and a target; absent with --no-draw.
struct Stage {
    HeadlessStage headless;
    engine::FrameView view;
    engine::FrameCapture target;
    NamedTimes passes;

    Stage(bool on_gpu, const BuiltShot& built, const ShotOptions& options, PictureSize size)
        : headless(on_gpu),
          view(makeFrameView(built.shot, *built.body, size.width, size.height,
                             renderQuality(options, headless.info().software))),
          target(size.width, size.height, [](uint64_t, engine::Image) {}) {}

    /// Draws and waits; `timed` frames count in the passes' times. Returns the GPU's time, ms.
    double draw(Session& session, bool timed) {
        engine::Renderer& renderer = headless.renderer();
        renderer.draw(session.mesh(), session.spheres(), view, target.framebuffer());
        glFinish();
        if (timed) {
            for (const auto& pass : renderer.lastPassTimes()) passes.add(pass.name, pass.ms);
        }
        return renderer.lastDrawMs();
    }
};

std::vector<FrameSample> timeFrames(const BenchOptions& options, Session& session, Stage* stage,
                                    StepStatus& status) {
    std::vector<FrameSample> samples;
    const auto warmup = static_cast<uint64_t>(options.warmup);
    const uint64_t frames = warmup + static_cast<uint64_t>(options.frames);
    ProgressBar bar;
    for (uint64_t frame = 0; frame < frames; ++frame) {
        const StopWatch watch;
        status = session.advance();
        if (status != StepStatus::kOk) break;
        const double draw_ms = stage != nullptr ? stage->draw(session, frame >= warmup) : 0;
        if (frame >= warmup) samples.push_back({watch.milliseconds(), session.lastSimMs(), draw_ms});
        bar.show(static_cast<double>(frame + 1) / static_cast<double>(frames), "timing");
    }
    return samples;
}

/// The timed frames go without the ledger, as a viewer would; a report gets it from the same frames once
/// more. Throws NumericalError if booking changed the run, which it must not.
EnergyLedger energyOfTheSameFrames(Session& timed, int frames) {
    BuildOptions options{.draw_geometry = timed.built().has_draw_geometry, .reuse = &timed.built()};
    Session session(buildShot(timed.built().shot, options, {}), {.draw = false});
    for (int frame = 0; frame < frames; ++frame) requireOk(session.advance());
    if (session.solver().stateHash() != timed.solver().stateHash())
        throw NumericalError(
            "the run with the energy ledger ended in another state than the timed one; report this");
    session.solver().measure();
    return session.solver().stats().energy;
}

void runBench(const BenchOptions& options) {
    const Shot shot = makeShot(options.shot);
    requireInRange("--frames", options.frames, kFrameRange, "");
    requireInRange("--warmup", options.warmup, kWarmupRange, "");
    const bool on_gpu = choosesCuda(shot);
    const PictureSize size =
        pictureSize(options.shot, on_gpu ? PictureSize{1920, 1080} : PictureSize{640, 360});
    const StopWatch watch;
    BuiltShot built = buildWithBar(shot, {.draw_geometry = !options.no_draw, .ledger = false});
    announce(built);
    std::unique_ptr<Stage> stage;
    if (!options.no_draw) stage = std::make_unique<Stage>(on_gpu, built, options.shot, size);
    Session session(std::move(built), {.draw = !options.no_draw});
    StepStatus status = StepStatus::kOk;
    const auto samples = timeFrames(options, session, stage.get(), status);

    session.solver().measure();
    RunReport report;
    if (stage) {
        report.gl_renderer = stage->headless.info().renderer;
        report.width = static_cast<uint32_t>(size.width);
        report.height = static_cast<uint32_t>(size.height);
        report.transfer_note = session.status().transfer_note;
        report.draw_passes = stage->passes.medians();
    }
    report.transfer = session.transfer();
    report.frames = samples.size();
    report.wall_seconds = watch.milliseconds() / 1000;
    report.times = summarise(samples);
    if (!options.json.empty()) {
        if (status == StepStatus::kOk)
            report.energy = energyOfTheSameFrames(session, static_cast<int>(options.warmup + options.frames));
        writeTextFile(options.json, reportJson(session.built(), report));
    }
    std::fputs(reportTable(session.built(), report).c_str(), stdout);
    requireOk(status);
}

}  // namespace

void addBenchCommand(CLI::App& app, BenchOptions& options) {
    auto* command = app.add_subcommand("bench", "Time simulation and drawing");
    addShotOptions(*command, options.shot);
    command->add_option("--frames", options.frames, "Frames to time")->type_name("N")->capture_default_str();
    command->add_option("--warmup", options.warmup, "Frames before the timed ones")
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--json", options.json, "Report of the run, JSON, SI units")->type_name("FILE");
    command->add_flag("--no-draw", options.no_draw, "Simulate only; needs no OpenGL");
    command->callback([&options] { runBench(options); });
}

}  // namespace demolish
