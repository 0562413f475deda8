// SPDX-License-Identifier: Apache-2.0
// One measurement at a time.
#include "app/calibrate/calibration_worker.h"

#include <utility>

#include "sim_cuda/api/errors.h"

namespace demolish {

void CalibrationWorker::start(const Shot& shot, std::shared_ptr<const BreakableBody> body) {
    if (busy()) return;
    job_ = std::make_shared<Job>();
    thread_ = std::jthread([job = job_, shot, body = std::move(body)](const std::stop_token& stop) {
        std::optional<Calibration> result;
        std::exception_ptr error;
        const auto report = [&](double fraction, const char*) {
            const std::lock_guard lock(job->mutex);
            job->fraction = fraction;
            return !stop.stop_requested();
        };
        try {
            result = calibrate(shot, body, {}, report);
        } catch (const Cancelled&) {
        } catch (...) {
            error = std::current_exception();
        }
        const std::lock_guard lock(job->mutex);
        if (!stop.stop_requested()) {
            job->result = std::move(result);
            job->error = error;
        }
        job->done = true;
    });
}

void CalibrationWorker::cancel() {
    thread_.request_stop();
}

double CalibrationWorker::fraction() const {
    if (!job_) return 0;
    const std::lock_guard lock(job_->mutex);
    return job_->fraction;
}

std::optional<Calibration> CalibrationWorker::take() {
    if (!job_ || !job_->done) return std::nullopt;
    const std::lock_guard lock(job_->mutex);
    if (job_->error) std::rethrow_exception(std::exchange(job_->error, nullptr));
    return std::exchange(job_->result, std::nullopt);
}

}  // namespace demolish
