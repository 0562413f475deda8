// SPDX-License-Identifier: Apache-2.0
// Building with a bar, and the one line that says where things run.
#include "app/commands/timed_loop.h"

#include <spdlog/spdlog.h>

#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "app/commands/interrupt.h"
#include "app/commands/machine_facts.h"
#include "app/commands/text_table.h"
#include "app/session/model_shot.h"
#include "app/session/shot_cost.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

/// What a thread that makes a shot tells the one that shows it.
class Making {
  public:
    void tell(double fraction) {
        const std::lock_guard lock(mutex_);
        fraction_ = fraction;
    }
    void note(const std::string& note) {
        const std::lock_guard lock(mutex_);
        note_ = note;
    }
    double fraction() {
        const std::lock_guard lock(mutex_);
        return fraction_;
    }
    /// Each note once.
    std::string takeNote() {
        const std::lock_guard lock(mutex_);
        return std::exchange(note_, {});
    }

  private:
    std::mutex mutex_;
    double fraction_ = 0;
    std::string note_;
};

BuiltShot make(const Shot& shot, const BuildOptions& options, Making& making) {
    const auto progress = [&making](double fraction, const char*) {
        making.tell(fraction);
        return !InterruptWatch::asked();
    };
    BuiltShot built = prepareShot(shot, options, progress);
    const ShotWork work = workOf(built.shot, built.setup);
    const bool on_gpu = choosesCuda(shot);
    if (mayBeSlow(work, on_gpu))
        making.note(slowNote(work, costOf(work, measurePace(on_gpu, work.particles))));
    makeSolver(built, progress);
    return built;
}

}  // namespace

/// Made on another thread: a stage may take minutes, and at an interrupt nobody waits for its end, since
/// nothing of it is kept. The program then ends without it (program.cpp).
BuiltShot buildWithBar(const Shot& shot, const BuildOptions& options) {
    const auto making = std::make_shared<Making>();
    std::packaged_task<BuiltShot()> task([=] { return make(shot, options, *making); });
    std::future<BuiltShot> built = task.get_future();
    std::thread(std::move(task)).detach();
    ProgressBar bar;
    const auto show = [&] {
        if (const std::string note = making->takeNote(); !note.empty()) {
            bar.finish();
            spdlog::warn("{}", note);
        }
        bar.show(making->fraction(), "making cells and bonds");
    };
    while (built.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready &&
           !InterruptWatch::asked())
        show();
    if (InterruptWatch::asked()) throw Interrupted("interrupted before the first frame; nothing was made");
    show();
    return built.get();
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
    const std::string remark =
        sizeRemark(built.shot, built.body->bounds_min, built.body->bounds_max, Advised::kTerminal);
    if (!remark.empty()) spdlog::warn("{}", remark);
}

void tellMessage(const Session& session) {
    if (const std::string message = session.status().message; !message.empty()) spdlog::warn("{}", message);
}

FrameWatch watchFrame(ProgressBar& bar, uint64_t done, uint64_t all, const char* label) {
    return [&bar, done, all, label](double share) {
        bar.show((static_cast<double>(done) + share) / static_cast<double>(all), label);
        return !InterruptWatch::asked();
    };
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
