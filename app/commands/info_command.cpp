// SPDX-License-Identifier: Apache-2.0
// Version, devices, renderer, transfer path: each line is asked of the machine, not assumed.
#include "app/commands/info_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "app/bridge/frame_bridge.h"
#include "app/commands/build_version.h"
#include "app/commands/help_text.h"
#include "app/commands/machine_facts.h"
#include "app/session/data_folder.h"
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

}  // namespace

void addInfoCommand(CLI::App& app) {
    auto* command =
        app.add_subcommand("info", "Version, devices, OpenGL renderer, and how frames travel to it");
    setExamples(*command, {"info"});
    command->callback([] { runInfo(); });
}

}  // namespace demolish
