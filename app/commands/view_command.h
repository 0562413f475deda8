// SPDX-License-Identifier: Apache-2.0
// demolish view: the window.
#pragma once
#include <string>

#include "app/commands/shot_options.h"

namespace demolish {

struct ViewOptions {
    ShotOptions shot;
    bool no_vsync = false;
    std::string script;  ///< hidden: drives the window, see panel/script_driver.h
};

void addViewCommand(CLI::App& app, ViewOptions& options);

}  // namespace demolish
