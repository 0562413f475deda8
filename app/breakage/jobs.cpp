// SPDX-License-Identifier: Apache-2.0
// posix_spawn of /proc/self/exe.
#include "app/breakage/jobs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kVisible = "CUDA_VISIBLE_DEVICES";

std::vector<std::string> environmentWith(const std::string& devices) {
    std::vector<std::string> all;
    for (char** entry = environ; *entry != nullptr; ++entry)
        if (devices.empty() || std::strncmp(*entry, kVisible, std::strlen(kVisible)) != 0)
            all.emplace_back(*entry);
    if (!devices.empty()) all.push_back(std::string(kVisible) + "=" + devices);
    return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Its stdout is closed to the table of the parent; stderr is shared.
pid_t start(std::vector<std::string> arguments, const std::string& devices) {
    arguments.insert(arguments.begin(), "demolish");
    std::vector<std::string> environment = environmentWith(devices);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointersTo(arguments).data(),
                                  pointersTo(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw DeviceError(std::string("could not start a job: ") + std::strerror(error));
    return child;
}

int exitCode(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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
    std::map<pid_t, size_t> slot_of;
    size_t next = 0, ended = 0;
    int failure = 0;
    const auto fill = [&](size_t slot) {
        if (next < arguments.size() && failure == 0) slot_of[start(arguments[next++], devices[slot])] = slot;
    };
    for (size_t slot = 0; slot < devices.size(); ++slot) fill(slot);
    while (!slot_of.empty()) {
        int status = 0;
        const pid_t child = wait(&status);
        if (child < 0 && errno == EINTR) continue;
        const auto entry = slot_of.find(child);
        if (entry == slot_of.end()) continue;
        const size_t slot = entry->second;
        slot_of.erase(entry);
        if (const int code = exitCode(status); code == 0)
            done(++ended);
        else if (failure == 0)
            failure = code;
        fill(slot);
    }
    if (failure != 0)
        throw Error(static_cast<ExitCode>(failure),
                    "a job ended with exit code " + std::to_string(failure) +
                        "; what is done stays, the same command goes on from there");
}

}  // namespace demolish
