// SPDX-License-Identifier: Apache-2.0
// From options to a timed run and its reports.
#include "app/commands/bench_command.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/commands/bench_run.h"
#include "app/commands/build_version.h"
#include "app/commands/help_text.h"
#include "app/commands/interrupt.h"
#include "app/commands/kernel_bench.h"
#include "app/commands/machine_facts.h"
#include "app/commands/methods_bench.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kFrameRange{1, 100000};
constexpr Range kWarmupRange{0, 100000};
constexpr PictureSize kDefaultSize{1920, 1080};
constexpr size_t kRecordingLimit = size_t{4} << 30;  // bytes

BenchPlan planFor(const BenchOptions& options, const Shot& shot) {
    if (options.no_draw && options.draw_only)
        throw UsageError("--no-draw and --draw-only exclude each other: nothing would be left to time");
    if (options.record && (options.no_draw || options.draw_only))
        throw UsageError(
            "--record keeps frames that are simulated and drawn; leave --no-draw and --draw-only");
    if (options.frames) requireInRange("--frames", *options.frames, kFrameRange, "");
    requireInRange("--warmup", options.warmup, kWarmupRange, "");
    BenchPlan plan;
    plan.mode = options.no_draw     ? BenchMode::kSimulateOnly
                : options.draw_only ? BenchMode::kDrawOnly
                                    : BenchMode::kSimulateAndDraw;
    plan.frames = options.frames ? static_cast<uint64_t>(*options.frames) : framesOfShot(shot);
    plan.warmup = static_cast<uint64_t>(options.warmup);
    return plan;
}

/// The timed frames go without the ledger, as a viewer would; a report gets it from the same frames once
/// more; none if that is interrupted. Throws NumericalError if booking changed the run, which it must not.
std::optional<EnergyBalance> energyOfTheSameFrames(Session& timed, uint64_t frames) try {
    const BuildOptions options{.draw_geometry = timed.built().has_draw_geometry, .reuse = &timed.built()};
    const auto goes_on = [](double, const char*) { return !InterruptWatch::asked(); };
    Session session(buildShot(timed.built().shot, options, goes_on), {.draw = false});
    ProgressBar bar;
    for (uint64_t frame = 0; frame < frames; ++frame) {
        requireOk(session.advance(watchFrame(bar, frame, frames, "booking energy")));
        if (InterruptWatch::asked()) return std::nullopt;
    }
    if (session.solver().stateHash() != timed.solver().stateHash())
        throw NumericalError(
            "the run with the energy ledger ended in another state than the timed one; report this");
    session.solver().measure();
    return session.energy();
} catch (const Cancelled&) {
    return std::nullopt;
}

RunReport reportOf(const BenchPlan& plan, const BenchRun& run, const Session& session,
                   const BenchStage* stage, PictureSize size) {
    RunReport report;
    report.mode = modeName(plan.mode);
    if (stage != nullptr) {
        report.gl_renderer = stage->info().renderer;
        report.gl_version = stage->info().version;
        report.quality = qualityName(stage->quality());
        report.width = static_cast<uint32_t>(size.width);
        report.height = static_cast<uint32_t>(size.height);
        report.transfer_note = session.status().transfer_note;
        report.draw_passes = run.passes.medians();
    }
    report.transfer = session.transfer();
    report.frames = run.samples.size();
    report.frame_seconds = leastSimulated(run.samples);
    report.times = summarise(run.samples);
    report.phases = summarisePhases(run.samples, session.built().shot.phases);
    return report;
}

/// The substep's options are the device, one size, and where to write.
void refuseForKernel(const BenchOptions& options) {
    const ShotOptions& shot = options.shot;
    const bool of_a_shot = !shot.scene.empty() || !shot.model.empty() || options.no_draw ||
                           options.draw_only || options.record || options.frames || shot.particle_size;
    const auto not_for_it = [](const auto& file) {
        return !file.second.empty() && file.first != "--json" && file.first != "--csv";
    };
    const auto& paths = options.files.paths;
    if (of_a_shot || std::any_of(paths.begin(), paths.end(), not_for_it))
        throw UsageError(
            "--kernel times the substep of a block and no scene; give it --device, --particles, --json or "
            "--csv "
            "only");
}

void runKernelBench(const BenchOptions& options) {
    refuseForKernel(options);
    Shot shot;
    shot.device = deviceChoice(options.shot);
    const bool cuda = choosesCuda(shot);
    std::vector<uint32_t> sizes(kernelSizes(cuda).begin(), kernelSizes(cuda).end());
    if (options.shot.particles) {
        requireInRange("--particles", *options.shot.particles, {8, kMaxParticles}, "");
        if (*options.shot.particles != std::floor(*options.shot.particles))
            throw UsageError("--particles must be a whole number");
        sizes = {static_cast<uint32_t>(*options.shot.particles)};
    } else if (!cuda) {
        spdlog::info("on the CPU only sizes up to {} are timed; --particles N asks for another",
                     sizes.back());
    }
    std::vector<KernelRow> rows;
    ProgressBar bar;
    for (const uint32_t size : sizes) {
        bar.show(static_cast<double>(rows.size()) / static_cast<double>(sizes.size()), "timing substeps");
        rows.push_back(timeKernel(cuda, size));
    }
    bar.finish();
    const KernelPlace place{cuda ? findCudaDevice().name : "CPU", gpuDriver(), machineName(), buildVersion(),
                            threadsInUse()};
    LastFiles files;
    files.write(options.files.at("--json"), [&] { return kernelJson(rows, place); });
    files.write(options.files.at("--csv"), [&] { return kernelCsv(rows, place); });
    std::fputs(kernelTable(rows, place).c_str(), stdout);
    files.requireAllWritten();
}

void refuseForMethods(const BenchOptions& options) {
    const auto not_for_it = [](const auto& file) { return !file.second.empty() && file.first != "--json"; };
    const auto& paths = options.files.paths;
    const bool of_one = !options.shot.method.empty() || options.draw_only || options.record;
    if (of_one || std::any_of(paths.begin(), paths.end(), not_for_it))
        throw UsageError(
            "--methods runs a shot by every method; leave out --method, --draw-only, --record, and files "
            "other than --json");
}

void runMethodsBench(const BenchOptions& options) {
    refuseForMethods(options);
    const std::vector<Method> methods = methodsToCompare(options.methods);
    Shot shot = makeShot(options.shot, "paper");
    if (options.shot.effects.empty()) shot.effects.on = false;
    const BenchPlan plan = planFor(options, shot);
    const PictureSize size = pictureSize(options.shot, kDefaultSize);
    const InterruptWatch interrupts;
    MethodsPlace place{shot.scene, "nobody", 0, 0, plan.frames};
    const std::vector<MethodRow> rows = compareMethods(shot, methods, plan, options.shot, size, place);
    LastFiles files;
    files.write(options.files.at("--json"), [&] { return methodsJson(rows, place); });
    std::fputs(methodsTable(rows, place).c_str(), stdout);
    files.requireAllWritten();
}

void runBench(const BenchOptions& options) {
    requireWritable(options.files);
    if (options.kernel) return runKernelBench(options);
    if (!options.methods.empty()) return runMethodsBench(options);
    Shot shot = makeShot(options.shot, "paper");
    if (options.shot.effects.empty()) shot.effects.on = false;  // what the paper times has none
    const BenchPlan plan = planFor(options, shot);
    const bool draws = plan.mode != BenchMode::kSimulateOnly;
    const bool on_gpu = choosesCuda(shot);
    const PictureSize size = pictureSize(options.shot, kDefaultSize);
    const InterruptWatch interrupts;
    const StopWatch watch;
    BuiltShot built = buildWithBar(shot, {.draw_geometry = draws, .ledger = false});
    announce(built);
    std::unique_ptr<BenchStage> stage;
    if (draws) stage = std::make_unique<BenchStage>(on_gpu, built, options.shot, size);
    Session session(std::move(built), {.draw = draws,
                                       .record = options.record || plan.mode == BenchMode::kDrawOnly,
                                       .memory_limit = kRecordingLimit});
    const BenchRun run = runBenchPlan(plan, session, stage.get());
    if (run.status == StepStatus::kOk && run.samples.empty())
        throw Interrupted("interrupted before the first timed frame; nothing was written");
    if (run.status == StepStatus::kOk) tellMessage(session);

    session.solver().measure();
    RunReport report = reportOf(plan, run, session, stage.get(), size);
    report.wall_seconds = watch.milliseconds() / 1000;
    FinishedRun finished{session.built(), report, run.samples, [&]() -> std::optional<EnergyBalance> {
                             if (run.status != StepStatus::kOk || InterruptWatch::asked())
                                 return std::nullopt;
                             return energyOfTheSameFrames(session, plan.frames);
                         }};
    LastFiles files;
    writeRunFiles(options.files, finished, files);
    std::fputs(reportTable(session.built(), report).c_str(), stdout);
    files.requireAllWritten();
    requireOk(run.status);
    if (InterruptWatch::asked())
        throw Interrupted("interrupted after " + std::to_string(run.samples.size()) + " of " +
                          std::to_string(plan.frames) + " frames; what was reported is of these");
}

}  // namespace

void addBenchCommand(CLI::App& app, BenchOptions& options) {
    auto* command = app.add_subcommand("bench", "Time simulation and drawing, phase by phase");
    addShotOptions(*command, options.shot);
    command->add_option("--frames", options.frames, "Frames to time (default: all phases of the scene)")
        ->type_name("N");
    command->add_option("--warmup", options.warmup, "Frames before the timed ones; then the shot starts anew")
        ->type_name("N")
        ->capture_default_str();
    addRunFileOptions(*command, options.files);
    command->add_flag("--no-draw", options.no_draw, "Simulate only; needs no OpenGL");
    command->add_flag("--draw-only", options.draw_only, "Time the drawing alone, of a recording of the shot");
    command->add_flag("--record", options.record,
                      "Keep every frame for scrubbing, as the window does; counts as transfer");
    command->add_flag(
        "--kernel", options.kernel,
        "Time the substep alone, of blocks of 2,000 to 1,000,000 particles, beside the machine's floors");
    command->add_flag(
        "--methods{all}", options.methods,
        "The shot by every method of the paper's comparison, in one table; --methods=ours,heavy: "
        "by these");
    setExamples(*command,
                {"bench vase --json vase.json --curve vase.svg", "bench bunny --particles 2000 --no-draw",
                 "bench --kernel --device cuda", "bench bunny --methods"});
    command->callback([&options] { runBench(options); });
}

}  // namespace demolish
