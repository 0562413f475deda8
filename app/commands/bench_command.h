// demolish bench: how fast it runs, step by step and frame by frame.
#pragma once
#include <string>

#include "app/commands/shot_options.h"

namespace demolish {

struct BenchOptions {
    ShotOptions shot;
    double frames = 120, warmup = 10;
    std::string json;
    bool no_draw = false;
};

void addBenchCommand(CLI::App& app, BenchOptions& options);

}  // namespace demolish
