// SPDX-License-Identifier: Apache-2.0
// demolish info: what this machine has, how frames would travel, and what a shot will take on it.
#pragma once
#include "app/commands/shot_options.h"

namespace CLI {
class App;
}

namespace demolish {

void addInfoCommand(CLI::App& app, ShotOptions& options);

}  // namespace demolish
