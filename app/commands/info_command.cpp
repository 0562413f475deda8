// SPDX-License-Identifier: Apache-2.0
// Version, devices, renderer, transfer path, the cost of a shot: each line is asked of the machine, not
// assumed.
#include "app/commands/info_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/bridge/frame_bridge.h"
#include "app/commands/build_version.h"
#include "app/commands/help_text.h"
#include "app/commands/machine_facts.h"
#include "app/commands/text_table.h"
#include "app/session/built_shot.h"
#include "app/session/data_folder.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_cost.h"
#include "engine/gl/error.h"
#include "engine/platform/headless_context.h"
#include "engine/platform/window.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"

namespace demolish {
namespace {

void printCuda(const CudaDevice& cuda) {
    if (cuda.usable)
        std::printf("CUDA device   %d: %s (driver %d.%d)\n", cuda.ordinal, cuda.name.c_str(),
                    cuda.driver_version / 1000, cuda.driver_version % 1000 / 10);
    else
        std::printf("CUDA device   none: %s\n",
                    cuda.problem.empty() ? "no usable GPU" : cuda.problem.c_str());
    std::printf("CUDA build    %s\n", cuda.built_with_cuda ? "yes" : "no");
}

void printEglDevices() {
    for (const auto& device : engine::listEglDevices()) {
        const std::string cuda =
            device.cuda_device ? ", CUDA device " + std::to_string(*device.cuda_device) : "";
        std::printf("EGL device    %d: %s%s%s%s\n", device.index, device.vendor.c_str(),
                    device.software ? ", software" : "", cuda.c_str(), device.usable ? "" : ", not usable");
    }
}

void printRenderer(const CudaDevice& cuda) {
    engine::HeadlessOptions options;
    if (cuda.usable) options.cuda_device = eglOrdinal(cuda.ordinal, std::getenv("CUDA_VISIBLE_DEVICES"));
    const engine::HeadlessContext context(options);
    const engine::ContextInfo& info = context.info();
    std::printf("GL renderer   %s (%s)\n", info.renderer.c_str(), info.platform.c_str());
    std::printf("GL version    %s\n", info.version.c_str());
    if (!info.note.empty()) std::printf("GL note       %s\n", info.note.c_str());
    const TransferProbe probe = probeTransfer(cuda.usable);
    std::printf("transfer      %s%s%s\n", transferName(probe.transfer), probe.note.empty() ? "" : ": ",
                probe.note.c_str());
}

void runInfo() {
    std::printf("demolish      %s\n", buildVersion());
    std::printf("processor     %s, %u threads\n", machineName().c_str(), threadsInUse());
    const CudaDevice cuda = findCudaDevice();
    printCuda(cuda);
    printEglDevices();
    printRenderer(cuda);
    std::string reason;
    const bool window = engine::Window::available(&reason);
    std::printf("window        %s%s\n", window ? "yes" : "no: ", window ? "" : reason.c_str());
    std::printf("data          %s\n", dataFolder().c_str());
    std::string scenes;
    for (const auto& name : assetNames("scenes")) scenes += " " + name;
    std::printf("scenes       %s\n", scenes.c_str());
}

void printPace(const char* name, const SubstepTime& time, const ShotWork& work) {
    std::printf("%-13s %s a substep, %.3g ns a particle\n", name, shownTime(time.of(work.particles)).c_str(),
                1e9 * time.of(work.particles) / work.particles);
}

/// Of shots whose bodies differ.
void printKinds(const BuiltShot& built) {
    const std::vector<SceneBody> bodies = bodiesOf(built.shot);
    const std::vector<size_t> alike = firstAlike(bodies);
    if (std::all_of(alike.begin(), alike.end(), [](size_t first) { return first == 0; })) return;
    for (size_t b = 0; b < bodies.size(); ++b) {
        if (alike[b] != b) continue;
        const Shot of = asOf(built.shot, bodies[b]);
        const BreakableBody& body = *built.cells.of_body[b];
        std::printf("  %-11s %zu of %s, %zu particles of %.3g mm each\n", of.material_name.c_str(),
                    static_cast<size_t>(std::count(alike.begin(), alike.end(), b)),
                    modelName(of.model).c_str(), body.particles.size(), 1000 * body.spacing);
    }
}

/// Of bodies whose bonds are stepped, timed on this machine.
void printCost(const Shot& shot, const BuiltShot& built, const ShotWork& work) {
    const bool on_gpu = choosesCuda(shot);
    const DevicePace pace = measurePace(on_gpu, work.particles);
    const ShotCost cost = costOf(work, pace);
    std::printf("time step     %.4g us: %u substeps a frame of 1/%g s\n", 1e6 * work.time_step, work.substeps,
                shot.fps / shot.time_scale);
    std::printf("making        cells in %s, settling in about %s (%llu substeps)\n",
                shownTime(built.build_seconds).c_str(), shownTime(cost.settle_seconds).c_str(),
                static_cast<unsigned long long>(work.settle_substeps));
    std::printf("a frame       about %s with all bodies awake, %s while all of them break\n",
                shownTime(cost.whole_frame_ms / 1000).c_str(),
                shownTime(cost.breaking_frame_ms / 1000).c_str());
    std::printf("measured on   %s\n", on_gpu ? findCudaDevice().name.c_str() : machineName().c_str());
    printPace("  whole", pace.whole, work);
    printPace("  breaking", pace.breaking, work);
    if (const std::string note = slowNote(work, cost); !note.empty())
        std::printf("note          %s\n", note.c_str());
}

/// Makes the cells, since the step follows from them, and no solver.
void printShot(const ShotOptions& options) {
    const Shot shot = makeShot(options);
    const BuiltShot built = prepareShot(shot, {.draw_geometry = false}, {});
    const ShotWork work = workOf(built.shot, built.setup);
    std::printf("shot          %s: %u %s, %u particles of %.3g mm, %u bonds\n", modelName(shot.model).c_str(),
                work.bodies, work.bodies == 1 ? "body" : "bodies", work.particles, 1000 * built.body->spacing,
                work.bonds);
    printKinds(built);
    if (work.steps_bonds) return printCost(shot, built, work);
    std::printf("making        cells in %s, no settling\n", shownTime(built.build_seconds).c_str());
    std::printf("a frame       method %s steps no bonds: rigid pieces, which are not priced here\n",
                methodName(shot.method));
}

}  // namespace

void addInfoCommand(CLI::App& app, ShotOptions& options) {
    auto* command = app.add_subcommand(
        "info", "Version, devices, OpenGL renderer and transfer; with a shot's options: what it will take");
    addShotOptions(*command, options);
    setExamples(*command, {"info", "info bunny --particles 100000"});
    command->callback([command, &options] {
        const auto given = command->get_options();
        const bool of_a_shot = std::any_of(given.begin(), given.end(),
                                           [](const CLI::Option* option) { return option->count() > 0; });
        of_a_shot ? printShot(options) : runInfo();
    });
}

}  // namespace demolish
