// SPDX-License-Identifier: Apache-2.0
// Another program that runs beside this one: started, fed, listened to, and always waited for.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace demolish {

/// Path of the program that runs now, as a program to start; right even after its file was replaced.
inline constexpr const char* kOwnProgram = "/proc/self/exe";

enum class ChildStream {
    kShared,   ///< the parent's own
    kNothing,  ///< empty to read, swallows what is written
    kPiped     ///< the other end is the ChildProcess
};

struct ChildPlan {
    std::vector<std::string> words{};      ///< what it is called, then its arguments
    std::string program{};                 ///< file to run; empty: words[0]. Looked for in PATH without a '/'
    std::vector<std::string> variables{};  ///< NAME=VALUE, in place of what the environment says
    ChildStream input = ChildStream::kNothing, output = ChildStream::kShared, errors = ChildStream::kShared;
    bool own_group = false;  ///< Ctrl-C does not reach it
    int shares = -1;         ///< an open file that it has as kSharedFile
};
/// Path by which a child opens what its parent shares with it, also where that has no name any more.
inline constexpr const char* kSharedFile = "/dev/fd/3";

/// It did not start. `what()` is the system's reason.
struct ChildError : std::runtime_error {
    explicit ChildError(int error_number);
    bool is_missing;  ///< there is no such program
};

struct ChildEnd {
    int exit_code = -1;  ///< -1: ended by a signal, or nobody knows
    int signal = 0;
    bool well() const { return exit_code == 0; }
    /// As a shell tells it.
    int code() const { return signal != 0 ? 128 + signal : exit_code; }
};

/// Inherits no open file but its three streams and what is shared, and no ignored SIGCHLD or SIGPIPE. The end
/// of a child can be learned only where SIGCHLD is not ignored: starting one gives it back its default.
class ChildProcess {
  public:
    using Clock = std::chrono::steady_clock;

    /// Throws ChildError.
    explicit ChildProcess(const ChildPlan& plan);
    /// Kills it where it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// To its piped input. False when it no longer reads; never a SIGPIPE.
    bool write(std::span<const uint8_t> bytes);
    void closeInput();
    /// From its piped output: how many bytes, 0 at its end; nothing when none came within `patience`.
    std::optional<size_t> read(std::span<uint8_t> into, std::chrono::milliseconds patience);

    /// Closes its input and waits. The same answer however often it is asked.
    ChildEnd wait();
    /// As wait(), but nothing if it runs on until then.
    std::optional<ChildEnd> waitUntil(Clock::time_point deadline);
    void kill();

  private:
    bool reap(int options);

    pid_t process_ = -1;
    int input_ = -1, output_ = -1;
    std::optional<ChildEnd> end_;
};

}  // namespace demolish
