// SPDX-License-Identifier: Apache-2.0
// posix_spawn, a socket pair for what the child reads, a pipe for what it writes.
#include "app/process/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

namespace demolish {
namespace {

constexpr int kPipeBytes = 1 << 20;  // fewer changes between the two processes than with the usual 64 KiB

void shut(int& descriptor) {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
}

/// Both ends, closed when the owner has gone.
struct Ends {
    int ours = -1, childs = -1;
    Ends() = default;
    Ends(const Ends&) = delete;
    Ends& operator=(const Ends&) = delete;
    ~Ends() {
        shut(ours);
        shut(childs);
    }
};

void openEnds(ChildStream input, Ends& in, ChildStream output, Ends& out) {
    std::array<int, 2> pair{};
    if (input == ChildStream::kPiped) {
        // A socket, since a send() to nobody can be an error of its own; a write() to a pipe is a signal.
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0) throw ChildError(errno);
        in.ours = pair[0];
        in.childs = pair[1];
        ::shutdown(in.childs, SHUT_WR);
    }
    if (output == ChildStream::kPiped) {
        if (pipe2(pair.data(), O_CLOEXEC) != 0) throw ChildError(errno);
        out.ours = pair[0];
        out.childs = pair[1];
        fcntl(out.ours, F_SETPIPE_SZ, kPipeBytes);
    }
}

std::vector<char*> pointersTo(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> environmentWith(const std::vector<std::string>& variables) {
    std::vector<std::string> all = variables;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string known = *entry;
        const auto names = [&](const std::string& variable) {
            return known.compare(0, known.find('=') + 1, variable, 0, variable.find('=') + 1) == 0;
        };
        if (std::none_of(variables.begin(), variables.end(), names)) all.push_back(known);
    }
    return all;
}

/// The system forgets how a child ended as long as its parent ignores SIGCHLD, as one may have been told to
/// by whoever started it.
void listenToChildren() {
    struct sigaction action {};
    sigaction(SIGCHLD, nullptr, &action);
    if (action.sa_handler != SIG_IGN && (action.sa_flags & SA_NOCLDWAIT) == 0) return;
    action.sa_flags &= ~SA_NOCLDWAIT;
    if (action.sa_handler == SIG_IGN) action.sa_handler = SIG_DFL;
    sigaction(SIGCHLD, &action, nullptr);
}

/// What the child does between its birth and its program.
class SpawnSteps {
  public:
    explicit SpawnSteps(bool own_group) {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
        sigset_t usual, none;
        sigemptyset(&usual);
        sigaddset(&usual, SIGCHLD);
        sigaddset(&usual, SIGPIPE);
        sigemptyset(&none);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setflags(&attributes,
                                 static_cast<short>(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK |
                                                    (own_group ? POSIX_SPAWN_SETPGROUP : 0)));
    }
    ~SpawnSteps() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
    }
    SpawnSteps(const SpawnSteps&) = delete;
    SpawnSteps& operator=(const SpawnSteps&) = delete;

    void stream(int descriptor, ChildStream kind, int piped) {
        if (kind == ChildStream::kPiped) posix_spawn_file_actions_adddup2(&actions, piped, descriptor);
        if (kind == ChildStream::kNothing)
            posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
    }
    /// `shared`: stays open as the first after the three streams; -1: none.
    void closeTheRest(int shared) {
        constexpr int kFirst = STDERR_FILENO + 1;
        if (shared >= 0) posix_spawn_file_actions_adddup2(&actions, shared, kFirst);
        posix_spawn_file_actions_addclosefrom_np(&actions, shared >= 0 ? kFirst + 1 : kFirst);
    }

    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
};

}  // namespace

ChildError::ChildError(int error_number)
    : std::runtime_error(std::strerror(error_number)), is_missing(error_number == ENOENT) {}

ChildProcess::ChildProcess(const ChildPlan& plan) {
    Ends in, out;
    openEnds(plan.input, in, plan.output, out);
    SpawnSteps steps(plan.own_group);
    steps.stream(STDIN_FILENO, plan.input, in.childs);
    steps.stream(STDOUT_FILENO, plan.output, out.childs);
    steps.stream(STDERR_FILENO, plan.errors, -1);
    steps.closeTheRest(plan.shares);
    listenToChildren();
    std::vector<std::string> words = plan.words, environment = environmentWith(plan.variables);
    const std::string& program = plan.program.empty() ? plan.words.at(0) : plan.program;
    if (const int error = posix_spawnp(&process_, program.c_str(), &steps.actions, &steps.attributes,
                                       pointersTo(words).data(), pointersTo(environment).data()))
        throw ChildError(error);
    std::swap(input_, in.ours);
    std::swap(output_, out.ours);
}

ChildProcess::~ChildProcess() {
    kill();
    wait();
    shut(output_);
}

bool ChildProcess::write(std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<size_t>(sent));
    }
    return true;
}

void ChildProcess::closeInput() {
    shut(input_);
}

std::optional<size_t> ChildProcess::read(std::span<uint8_t> into, std::chrono::milliseconds patience) {
    pollfd waiting{output_, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(patience.count())) <= 0) return std::nullopt;
    const ssize_t got = ::read(output_, into.data(), into.size());
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return std::nullopt;
    return got < 0 ? 0 : static_cast<size_t>(got);
}

bool ChildProcess::reap(int options) {
    while (!end_) {
        int status = 0;
        const pid_t ended = waitpid(process_, &status, options);
        if (ended == 0) return false;
        if (ended < 0 && errno == EINTR) continue;
        ChildEnd end;  // unknown if somebody else has reaped it
        if (ended > 0 && WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
        if (ended > 0 && WIFSIGNALED(status)) end.signal = WTERMSIG(status);
        end_ = end;
    }
    return true;
}

ChildEnd ChildProcess::wait() {
    closeInput();
    reap(0);
    return *end_;
}

std::optional<ChildEnd> ChildProcess::waitUntil(Clock::time_point deadline) {
    closeInput();
    for (std::chrono::milliseconds pause(1); !reap(WNOHANG);
         pause = std::min(2 * pause, decltype(pause)(16))) {
        if (Clock::now() >= deadline) return std::nullopt;
        std::this_thread::sleep_for(pause);
    }
    return end_;
}

void ChildProcess::kill() {
    if (!end_) ::kill(process_, SIGKILL);
}

}  // namespace demolish
