// One build at a time; the latest wish wins.
#include "app/session/rebuild_worker.h"

#include "sim_cuda/api/errors.h"

namespace demolish {

RebuildWorker::~RebuildWorker() {
    cancel();
}

void RebuildWorker::start(const Shot& shot, const BuiltShot& reuse) {
    cancel();
    BuiltShot parts;
    parts.shot = reuse.shot;
    parts.mesh = reuse.mesh;
    parts.body = reuse.body;
    parts.variants = reuse.variants;
    parts.has_draw_geometry = reuse.has_draw_geometry;
    progress_ = {};
    busy_ = true;
    thread_ = std::jthread([this, shot, parts = std::move(parts)](std::stop_token stop) mutable {
        run(std::move(stop), std::move(shot), std::move(parts));
    });
}

void RebuildWorker::cancel() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    result_.reset();
    error_ = nullptr;
    busy_ = false;
}

RebuildWorker::Progress RebuildWorker::progress() const {
    const std::lock_guard lock(mutex_);
    return progress_;
}

void RebuildWorker::run(std::stop_token stop, Shot shot, BuiltShot reuse) {
    const auto report = [&](double fraction, const char* stage) {
        const std::lock_guard lock(mutex_);
        progress_ = {fraction, stage};
        return !stop.stop_requested();
    };
    std::optional<BuiltShot> built;
    std::exception_ptr error;
    try {
        built = buildShot(shot, {.draw_geometry = reuse.has_draw_geometry, .reuse = &reuse}, report);
    } catch (const Cancelled&) {
    } catch (...) {
        error = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (!stop.stop_requested()) {
        result_ = std::move(built);
        error_ = error;
    }
    busy_ = false;
}

std::optional<BuiltShot> RebuildWorker::take() {
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    return std::exchange(result_, std::nullopt);
}

}  // namespace demolish
