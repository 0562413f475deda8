// Builds shots on a thread of its own while the old one goes on drawing.
#pragma once
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/session/built_shot.h"

namespace demolish {

class RebuildWorker {
  public:
    RebuildWorker() = default;
    ~RebuildWorker();
    RebuildWorker(const RebuildWorker&) = delete;
    RebuildWorker& operator=(const RebuildWorker&) = delete;

    /// Cancels what is running and starts anew. What may be reused is copied (shared pointers), not referred
    /// to.
    void start(const Shot& shot, const BuiltShot& reuse);
    void cancel();
    bool busy() const { return busy_; }

    struct Progress {
        double fraction = 0;
        std::string stage;
    };
    Progress progress() const;

    /// What became of the last start(): nothing yet, a shot, or an error (rethrown). A cancelled build gives
    /// nothing.
    std::optional<BuiltShot> take();

  private:
    void run(std::stop_token stop, Shot shot, BuiltShot reuse);

    std::atomic<bool> busy_ = false;
    mutable std::mutex mutex_;
    Progress progress_;
    std::optional<BuiltShot> result_;
    std::exception_ptr error_;
    std::jthread thread_;
};

}  // namespace demolish
