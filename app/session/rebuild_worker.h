// SPDX-License-Identifier: Apache-2.0
// Builds shots on threads of their own while the old one goes on drawing.
#pragma once
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/session/built_shot.h"

namespace demolish {

class RebuildWorker {
  public:
    RebuildWorker() = default;
    /// Waits for what is still being built.
    ~RebuildWorker() = default;
    RebuildWorker(const RebuildWorker&) = delete;
    RebuildWorker& operator=(const RebuildWorker&) = delete;

    /// Cancels what is running and starts anew. What may be reused is copied (shared pointers), not referred
    /// to.
    void start(const Shot& shot, const BuiltShot& reuse);
    /// Returns at once, since whoever draws must not wait for the end of a stage; the thread ends by itself.
    /// What is built already goes.
    void cancel();
    bool busy() const { return job_ && !job_->done; }

    struct Progress {
        double fraction = 0;
        std::string stage;
    };
    Progress progress() const;

    /// What became of the last start(): nothing yet, a shot, or an error (rethrown). A cancelled build gives
    /// nothing.
    std::optional<BuiltShot> take();

  private:
    /// One build; its thread and whoever waits for it hold it together.
    struct Job {
        std::mutex mutex;
        Progress progress;
        std::optional<BuiltShot> result;
        std::exception_ptr error;
        std::atomic<bool> done = false;
    };
    struct Worker {
        std::shared_ptr<const Job> job;
        std::jthread thread;
    };
    static void run(const std::stop_token& stop, Job& job, const Shot& shot, const BuiltShot& reuse);
    void endWorkers();

    std::shared_ptr<Job> job_;     ///< of the last start(); null when cancelled
    std::vector<Worker> workers_;  ///< oldest first, cancelled ones included
};

}  // namespace demolish
