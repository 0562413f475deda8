// SPDX-License-Identifier: Apache-2.0
// The latest wish wins.
#include "app/session/rebuild_worker.h"

#include <utility>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr size_t kMostWorkers = 3;  // cancelled builds still hold their memory

}  // namespace

void RebuildWorker::start(const Shot& shot, const BuiltShot& reuse) {
    cancel();
    endWorkers();
    BuiltShot parts;
    parts.shot = reuse.shot;
    parts.setup.params.ledger = reuse.setup.params.ledger;
    parts.cells = reuse.cells;
    parts.body = reuse.body;
    parts.has_draw_geometry = reuse.has_draw_geometry;
    job_ = std::make_shared<Job>();
    workers_.push_back(
        {job_, std::jthread([job = job_, shot, parts = std::move(parts)](const std::stop_token& stop) {
             run(stop, *job, shot, parts);
         })});
}

void RebuildWorker::cancel() {
    for (Worker& worker : workers_) worker.thread.request_stop();
    if (!job_) return;
    // Ready, and not taken: the solver must not wait for the next build to go.
    const std::shared_ptr<Job> job = std::exchange(job_, nullptr);
    std::optional<BuiltShot> unwanted;
    const std::lock_guard lock(job->mutex);
    unwanted.swap(job->result);
}

/// Forgets the finished ones, and waits where there would be too many.
void RebuildWorker::endWorkers() {
    std::erase_if(workers_, [](const Worker& worker) { return worker.job->done.load(); });
    while (workers_.size() >= kMostWorkers) workers_.erase(workers_.begin());
}

RebuildWorker::Progress RebuildWorker::progress() const {
    if (!job_) return {};
    const std::lock_guard lock(job_->mutex);
    return job_->progress;
}

void RebuildWorker::run(const std::stop_token& stop, Job& job, const Shot& shot, const BuiltShot& reuse) {
    const auto report = [&](double fraction, const char* stage) {
        const std::lock_guard lock(job.mutex);
        job.progress = {fraction, stage};
        return !stop.stop_requested();
    };
    std::optional<BuiltShot> built;
    std::exception_ptr error;
    try {
        built = buildShot(
            shot,
            {.draw_geometry = reuse.has_draw_geometry, .ledger = reuse.setup.params.ledger, .reuse = &reuse},
            report);
    } catch (const Cancelled&) {
    } catch (...) {
        error = std::current_exception();
    }
    const std::lock_guard lock(job.mutex);
    if (!stop.stop_requested()) {  // else after the last look at the progress
        job.result = std::move(built);
        job.error = error;
    }
    job.done = true;
}

std::optional<BuiltShot> RebuildWorker::take() {
    if (!job_) return std::nullopt;
    const std::lock_guard lock(job_->mutex);
    if (job_->error) std::rethrow_exception(std::exchange(job_->error, nullptr));
    return std::exchange(job_->result, std::nullopt);
}

}  // namespace demolish
