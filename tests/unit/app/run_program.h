// SPDX-License-Identifier: Apache-2.0
// Starts the built program and waits for it.
#pragma once
#include <string>
#include <vector>

namespace demolish::test {

struct ProgramRun {
    int exit_code = -1;
    std::string out, err;
};

/// DEMOLISH_PROGRAM of the environment, else where it was built. Empty if there is none.
std::string programPath();
/// `environment`: NAME=VALUE set for the program alone. `prefix`: words before the program's name (xvfb-run
/// ...).
ProgramRun runProgram(const std::vector<std::string>& arguments,
                      const std::vector<std::string>& environment = {},
                      const std::vector<std::string>& prefix = {});

}  // namespace demolish::test
