// SPDX-License-Identifier: Apache-2.0
// `demolish check FILE`: what a model file holds, what is done to close it, whether it will break.
#pragma once
#include <string>

#include "app/commands/shot_options.h"

namespace demolish {

struct CheckOptions {
    ShotOptions shot;
    std::string json;
};

void addCheckCommand(CLI::App& app, CheckOptions& options);

}  // namespace demolish
