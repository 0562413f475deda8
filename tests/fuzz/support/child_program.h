// SPDX-License-Identifier: Apache-2.0
// Runs a program to its end or to a limit, and says how it ended.
#pragma once
#include <string>
#include <vector>

namespace demolish::fuzz {

struct ChildLimits {
    double seconds = 60;     ///< of wall time; then the child and what it started are killed
    double cpu_seconds = 0;  ///< > 0: the same for its own processor time, which other work does not lengthen
    double kill_after = 0;   ///< s; > 0: the child alone gets SIGKILL then
};

struct ChildEnd {
    int exit_code = 0;  ///< where it ended by itself
    int signal = 0;     ///< that ended it, 0: none
    bool timed_out = false;
    double seconds = 0;    ///< wall time
    std::string out, err;  ///< all that it wrote

    bool endedWith(int code) const { return !timed_out && signal == 0 && exit_code == code; }
};

/// `environment`: NAME=VALUE, set for the child alone. Throws std::runtime_error if no process can be made.
ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits,
                  const std::vector<std::string>& environment = {});

/// "exit 3", "signal 11 (Segmentation fault)", "still running after 60 s".
std::string describe(const ChildEnd& end);
/// As a shell reads them: quoted where it must be.
std::string commandLine(const std::vector<std::string>& words);
/// This program's own file.
std::string ownProgram();

}  // namespace demolish::fuzz
