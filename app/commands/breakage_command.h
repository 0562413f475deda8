// SPDX-License-Identifier: Apache-2.0
// `demolish breakage`: the paper's experiment with round specimens on a wall (4.1, Figs 1 and 2).
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace demolish {

struct BreakageOptions {
    std::vector<std::string> experiments;  ///< names or files; empty: see runBreakage
    std::string out, device = "auto";
    std::optional<double> packings, velocities, batch, index;  ///< whole numbers, checked when used
    double jobs = 1;
    bool full = false, count = false, quiet = false;
};

void addBreakageCommand(CLI::App& app, BreakageOptions& options);

}  // namespace demolish
