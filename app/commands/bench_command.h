// SPDX-License-Identifier: Apache-2.0
// demolish bench: how fast it runs, phase by phase, beside the paper's numbers; or the substep alone.
#pragma once
#include <optional>
#include <string>

#include "app/commands/run_files.h"
#include "app/commands/shot_options.h"

namespace demolish {

struct BenchOptions {
    ShotOptions shot;
    std::optional<double> frames;  ///< none: to the end of the shot's last phase
    double warmup = 10;
    RunFiles files{RunCommand::kBench};
    bool no_draw = false, draw_only = false, record = false, kernel = false;
    std::string methods;  ///< to compare: names with commas, or "all"; empty: no comparison
};

void addBenchCommand(CLI::App& app, BenchOptions& options);

}  // namespace demolish
