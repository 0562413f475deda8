// SPDX-License-Identifier: Apache-2.0
// fork, exec, two files for what it says; a group of its own, so that what it started ends with it.
#include "tests/fuzz/support/child_program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace demolish::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// s, of all its threads; 0 once it has ended.
double cpuSeconds(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A file without a name.
int scratchFile() {
    std::string name = (std::filesystem::temp_directory_path() / "demolish_fuzz_XXXXXX").string();
    const int file = mkstemp(name.data());
    if (file < 0) throw std::runtime_error("no file in " + std::filesystem::temp_directory_path().string());
    unlink(name.c_str());
    fcntl(file, F_SETFD, FD_CLOEXEC);
    return file;
}

std::string contentOf(int file) {
    std::string text;
    std::array<char, 4096> block{};
    lseek(file, 0, SEEK_SET);
    for (ssize_t n = 0; (n = read(file, block.data(), block.size())) > 0;)
        text.append(block.data(), static_cast<size_t>(n));
    close(file);
    return text;
}

[[noreturn]] void become(std::vector<char*>& words, const std::vector<std::string>& environment, int out,
                         int err) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing of ours outlives a test that was stopped
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    for (const auto& setting : environment) {
        const size_t equals = setting.find('=');
        setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
    }
    execvp(words[0], words.data());
    _exit(127);
}

}  // namespace

ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits,
                  const std::vector<std::string>& environment) {
    std::vector<std::string> copies = words;
    std::vector<char*> pointers;
    for (auto& word : copies) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const int out = scratchFile(), err = scratchFile();
    const auto begun = Clock::now();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error(std::string("no new process: ") + std::strerror(errno));
    if (child == 0) become(pointers, environment, out, err);
    setpgid(child, child);
    ChildEnd end;
    int status = 0;
    for (bool killed = false; waitpid(child, &status, WNOHANG) == 0;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        end.seconds = secondsSince(begun);
        if (limits.kill_after > 0 && end.seconds > limits.kill_after && !killed) {
            killed = true;
            kill(child, SIGKILL);
        }
        const bool over = end.seconds > limits.seconds ||
                          (limits.cpu_seconds > 0 && cpuSeconds(child) > limits.cpu_seconds);
        if (over && !end.timed_out) {
            end.timed_out = true;
            kill(-child, SIGKILL);
        }
    }
    end.seconds = secondsSince(begun);
    if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    end.out = contentOf(out);
    end.err = contentOf(err);
    return end;
}

std::string describe(const ChildEnd& end) {
    if (end.timed_out) return "still running after " + std::to_string(static_cast<int>(end.seconds)) + " s";
    if (end.signal != 0) return "signal " + std::to_string(end.signal) + " (" + strsignal(end.signal) + ")";
    return "exit " + std::to_string(end.exit_code);
}

std::string commandLine(const std::vector<std::string>& words) {
    std::string line;
    for (const auto& word : words) {
        const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\$*?&|;<>()") == std::string::npos;
        line += (line.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
    }
    return line;
}

std::string ownProgram() {
    return std::filesystem::read_symlink("/proc/self/exe").string();
}

}  // namespace demolish::fuzz
