// SPDX-License-Identifier: Apache-2.0
// Building with a bar, and the one line that says where things run.
#include "app/commands/timed_loop.h"

#include <spdlog/spdlog.h>

#include "app/commands/interrupt.h"
#include "app/commands/machine_facts.h"
#include "app/commands/text_table.h"
#include "sim_cuda/api/errors.h"

namespace demolish {

BuiltShot buildWithBar(const Shot& shot, const BuildOptions& options) {
    ProgressBar bar;
    const auto progress = [&bar](double fraction, const char*) {
        if (InterruptWatch::asked())
            throw Interrupted("interrupted before the first frame; nothing was made");
        bar.show(fraction, "making cells and bonds");
        return true;
    };
    return buildShot(shot, options, progress);
}

void announce(const BuiltShot& built) {
    const CudaDevice cuda = findCudaDevice();
    if (built.solver->onGpu())
        spdlog::info("simulating on the GPU: {}", built.solver->deviceName());
    else if (built.shot.device == DeviceChoice::kCpu)
        spdlog::info("simulating on the CPU ({} threads), as asked for", threadsInUse());
    else
        spdlog::info("simulating on the CPU ({} threads): {}", threadsInUse(),
                     cuda.problem.empty() ? "no usable GPU" : cuda.problem);
    const FrameStats& stats = built.solver->stats();
    spdlog::info("{}: {} particles of {:.3g} mm, {} bonds, {:.3g} kg; made in {:.2f} s",
                 modelName(built.shot.model), stats.particles, 1000 * built.body->spacing, stats.bonds,
                 stats.mass, built.build_seconds);
}

FrameSample sampleOf(const Session& session, TriangleCounter& triangles, double frame_ms, double draw_ms) {
    FrameSample sample{frame_ms, session.lastSimMs(), draw_ms, session.lastTransferMs()};
    sample.stats = session.status().stats;
    sample.triangles = triangles.count(session.mesh(), sample.stats.bonds_broken);
    return sample;
}

void requireOk(StepStatus status) {
    if (status != StepStatus::kOk) throw NumericalError(describe(status));
}

}  // namespace demolish
