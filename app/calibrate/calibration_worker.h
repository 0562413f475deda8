// SPDX-License-Identifier: Apache-2.0
// Measures a shot's threshold on a thread of its own while the window goes on drawing.
#pragma once
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/calibrate/calibration.h"

namespace demolish {

class CalibrationWorker {
  public:
    /// On the CPU, so that the picture keeps the GPU: both give the same bits. `body`: the shot's filling.
    /// Does nothing while one is running.
    void start(const Shot& shot, std::shared_ptr<const BreakableBody> body);
    /// Returns at once; the thread ends after the trial that it is in. Nothing comes of a cancelled start(),
    /// though that trial was its last.
    void cancel();
    bool busy() const { return job_ && !job_->done; }
    double fraction() const;

    /// What became of the last start(): nothing yet, a threshold, or an error (rethrown), once.
    std::optional<Calibration> take();

  private:
    struct Job {
        std::mutex mutex;
        double fraction = 0;
        std::optional<Calibration> result;
        std::exception_ptr error;
        std::atomic<bool> done = false;
    };
    std::shared_ptr<Job> job_;
    std::jthread thread_;  ///< last member: ends before what it uses
};

}  // namespace demolish
