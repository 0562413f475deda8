// SPDX-License-Identifier: Apache-2.0
// The context is matched to the CUDA device, so that frames can travel by interop.
#include "app/commands/headless_stage.h"

#include <spdlog/spdlog.h>

#include <cstdlib>

#include "app/bridge/frame_bridge.h"
#include "app/session/data_folder.h"
#include "sim_cuda/api/solver.h"

namespace demolish {
namespace {

engine::HeadlessOptions optionsFor(bool on_gpu) {
    engine::HeadlessOptions options;
    if (on_gpu)
        options.cuda_device = eglOrdinal(findCudaDevice().ordinal, std::getenv("CUDA_VISIBLE_DEVICES"));
    return options;
}

}  // namespace

HeadlessStage::HeadlessStage(bool on_gpu)
    : context_(optionsFor(on_gpu)), renderer_(dataFolder() / "shaders") {
    if (!context_.info().note.empty()) spdlog::warn("{}", context_.info().note);
}

}  // namespace demolish
