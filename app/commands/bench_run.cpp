// SPDX-License-Identifier: Apache-2.0
// The loops of the three ways to time a shot.
#include "app/commands/bench_run.h"
#include "app/commands/tell_refusal.h"

#include <glad/gl.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "app/commands/interrupt.h"
#include "app/session/picture.h"

namespace demolish {
namespace {

constexpr uint64_t kFramesWithoutPhases = 120;

/// Says so if there was no room for all frames. The first that is kept is the shot before its first step.
void tellIfFull(const Session& session, uint64_t frames) {
    const size_t recorded = session.status().recorded_frames;
    if (recorded > 0 && recorded <= frames)
        spdlog::warn("memory for the recording sufficed for {} of {} frames: the others are left out",
                     recorded - 1, frames);
}

BenchRun stepAndDraw(const BenchPlan& plan, Session& session, BenchStage* stage) {
    BenchRun run;
    ProgressBar bar;
    TriangleCounter triangles;
    const auto frame = [&](uint64_t done, uint64_t all, bool timed) {
        const StopWatch watch;
        run.status = session.advance(watchFrame(bar, done, all, timed ? "timing" : "warming up"));
        if (run.status != StepStatus::kOk || session.frameUnderWay()) return;
        if (stage != nullptr) stage->draw(session);
        const double frame_ms = watch.milliseconds();
        if (!timed) return;
        const double draw_ms = stage != nullptr ? stage->lastDrawMs() : 0;
        run.samples.push_back(sampleOf(session, triangles, frame_ms, draw_ms));
        if (stage != nullptr) stage->addPasses(run.passes);
    };
    const auto goes_on = [&] { return run.status == StepStatus::kOk && !InterruptWatch::asked(); };
    for (uint64_t k = 0; k < plan.warmup && goes_on(); ++k) frame(k, plan.warmup, false);
    if (InterruptWatch::asked()) return run;
    session.apply(command::Reset{}, 0);
    run.status = StepStatus::kOk;
    for (uint64_t k = 0; k < plan.frames && goes_on(); ++k) {
        frame(k, plan.frames, true);
        bar.show(static_cast<double>(k + 1) / static_cast<double>(plan.frames), "timing");
    }
    if (goes_on()) tellIfFull(session, plan.frames);
    return run;
}

BenchRun drawRecorded(const BenchPlan& plan, Session& session, BenchStage& stage) {
    BenchRun run;
    ProgressBar bar;
    TriangleCounter triangles;
    for (uint64_t k = 0; k < plan.frames && run.status == StepStatus::kOk; ++k) {
        run.status = session.advance(watchFrame(bar, k, plan.frames, "recording"));
        if (InterruptWatch::asked()) return run;
        bar.show(static_cast<double>(k + 1) / static_cast<double>(plan.frames), "recording");
    }
    const size_t recorded = session.status().recorded_frames;  // the first is the shot before its first step
    if (run.status == StepStatus::kOk) tellIfFull(session, plan.frames);
    for (uint64_t k = 0; k < plan.warmup; ++k) stage.draw(session);
    for (size_t k = 1; k < recorded && !InterruptWatch::asked(); ++k) {
        session.apply(command::Scrub{k}, 0);
        stage.wait();
        const StopWatch watch;
        stage.draw(session);
        const double frame_ms = watch.milliseconds();
        run.samples.push_back(sampleOf(session, triangles, frame_ms, stage.lastDrawMs()));
        stage.addPasses(run.passes);
        bar.show(static_cast<double>(k) / static_cast<double>(recorded - 1), "drawing");
    }
    return run;
}

}  // namespace

const char* modeName(BenchMode mode) {
    switch (mode) {
        case BenchMode::kSimulateAndDraw:
            return "simulate and draw";
        case BenchMode::kSimulateOnly:
            return "simulate only";
        case BenchMode::kDrawOnly:
            return "draw only";
    }
    return "";
}

BenchStage::BenchStage(bool on_gpu, const BuiltShot& built, const ShotOptions& options, PictureSize size)
    : headless_(on_gpu),
      view_(makeFrameView(built.shot, built.cells.of_body, size.width, size.height,
                          renderQuality(options, headless_.info().software))),
      target_(size.width, size.height, [](uint64_t, const engine::Image&) {}) {
    view_.samples = windowSamples(headless_.info().software);
}

void BenchStage::draw(const Session& session) {
    const BuiltShot& built = session.built();
    const double time = session.status().stats.time;
    view_.camera = shotCamera(built.shot, built.cells.of_body, time);
    hangCables(built.shot, time, view_);
    draw(session.mesh(), session.spheres());
}

void BenchStage::draw(const engine::FractureMesh* mesh, std::span<const engine::SphereDraw> spheres) {
    headless_.renderer().draw(mesh, spheres, view_, target_.framebuffer());
    tellRefusal(headless_.renderer());
    wait();
}

double BenchStage::lastDrawMs() {
    return headless_.renderer().lastDrawMs();
}

void BenchStage::wait() {
    glFinish();
}

void BenchStage::addPasses(NamedTimes& passes) {
    for (const auto& pass : headless_.renderer().lastPassTimes()) passes.add(pass.name, pass.ms);
}

BenchRun runBenchPlan(const BenchPlan& plan, Session& session, BenchStage* stage) {
    if (plan.mode == BenchMode::kDrawOnly) return drawRecorded(plan, session, *stage);
    return stepAndDraw(plan, session, stage);
}

uint64_t framesOfShot(const Shot& shot) {
    double end = 0;
    for (const auto& phase : shot.phases) end = std::max(end, phase.to);
    if (end <= 0) return kFramesWithoutPhases;
    return static_cast<uint64_t>(std::ceil(end * shot.fps / shot.time_scale - 1e-6));
}

double leastSimulated(std::span<const FrameSample> samples) {
    if (samples.size() < 2) return 0;
    double least = samples[1].stats.time - samples[0].stats.time;
    for (size_t i = 2; i < samples.size(); ++i)
        least = std::min(least, samples[i].stats.time - samples[i - 1].stats.time);
    return least;
}

}  // namespace demolish
