// SPDX-License-Identifier: Apache-2.0
// A thread for each job, which starts one process after the other.
#include "app/breakage/jobs.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

#include "app/process/child_process.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kVisible = "CUDA_VISIBLE_DEVICES";

/// The items that wait, and what became of those that do not.
class JobQueue {
  public:
    JobQueue(const std::vector<std::vector<std::string>>& arguments,
             const std::function<void(size_t done)>& done)
        : arguments_(arguments), done_(done) {}

    /// One process after the other, until none is left or one has failed. `device`: empty, or the GPU that
    /// they see.
    void work(const std::string& device) {
        while (const auto* arguments = next()) {
            try {
                note(run(*arguments, device));
            } catch (const ChildError& error) {
                fail(DeviceError(std::string("could not start a job: ") + error.what()));
            }
        }
    }

    /// Throws what the first one that failed has left.
    void requireAllWell() const {
        if (error_) throw Error(*error_);
    }

  private:
    /// Its exit code. Its stdout is closed to the table of the parent; stderr is shared.
    static int run(const std::vector<std::string>& arguments, const std::string& device) {
        ChildPlan plan{.words = {"demolish"}, .program = kOwnProgram, .output = ChildStream::kNothing};
        plan.words.insert(plan.words.end(), arguments.begin(), arguments.end());
        if (!device.empty()) plan.variables.push_back(std::string(kVisible) + "=" + device);
        return ChildProcess(plan).wait().code();
    }

    const std::vector<std::string>* next() {
        const std::lock_guard lock(mutex_);
        const bool goes_on = next_ < arguments_.size() && !error_;
        return goes_on ? &arguments_[next_++] : nullptr;
    }
    void note(int code) {
        if (code != 0)
            return fail(Error(static_cast<ExitCode>(code),
                              "a job ended with exit code " + std::to_string(code) +
                                  "; what is done stays, the same command goes on from there"));
        const std::lock_guard lock(mutex_);
        done_(++ended_);
    }
    void fail(const Error& error) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = error;
    }

    const std::vector<std::vector<std::string>>& arguments_;
    const std::function<void(size_t done)>& done_;
    std::mutex mutex_;
    size_t next_ = 0, ended_ = 0;
    std::optional<Error> error_;
};

}  // namespace

std::string visibleDevice(size_t slot, const char* cuda_visible_devices) {
    if (cuda_visible_devices == nullptr || *cuda_visible_devices == 0) return std::to_string(slot);
    std::vector<std::string> names(1);
    for (const char* c = cuda_visible_devices; *c != 0; ++c)
        if (*c == ',')
            names.emplace_back();
        else
            names.back() += *c;
    if (slot >= names.size())
        throw UsageError("CUDA_VISIBLE_DEVICES names " + std::to_string(names.size()) +
                         " GPUs; ask for that many --jobs at most");
    return names[slot];
}

void checkGpus(size_t jobs, size_t gpus) {
    if (jobs > gpus)
        throw UsageError("--jobs " + std::to_string(jobs) + ", but this machine has " + std::to_string(gpus) +
                         (gpus == 1 ? " GPU" : " GPUs") + "; ask for that many at most");
}

void runJobs(const std::vector<std::vector<std::string>>& arguments, size_t jobs, bool on_gpu,
             const std::function<void(size_t done)>& done) {
    std::vector<std::string> devices(std::min(jobs, arguments.size()));
    for (size_t slot = 0; on_gpu && slot < devices.size(); ++slot)
        devices[slot] = visibleDevice(slot, std::getenv(kVisible));
    JobQueue queue(arguments, done);
    std::vector<std::jthread> slots;
    for (const std::string& device : devices) slots.emplace_back([&] { queue.work(device); });
    slots.clear();
    queue.requireAllWell();
}

}  // namespace demolish
