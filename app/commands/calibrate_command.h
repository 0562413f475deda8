// SPDX-License-Identifier: Apache-2.0
// demolish calibrate: from which velocity a shot breaks its body.
#pragma once
#include <string>

#include "app/commands/shot_options.h"

namespace demolish {

struct CalibrateOptions {
    ShotOptions shot;
    double packings = 1, tolerance = 0.05;
    std::string json;
    bool no_cache = false;
};

void addCalibrateCommand(CLI::App& app, CalibrateOptions& options);

}  // namespace demolish
