// SPDX-License-Identifier: Apache-2.0
// demolish scene: the scene file of a set, to be edited.
#pragma once
#include <string>

#include "app/commands/shot_options.h"

namespace CLI {
class App;
}

namespace demolish {

struct SceneOptions {
    ShotOptions shot;  ///< model, up, unit
    std::string out;
};
void addSceneCommand(CLI::App& app, SceneOptions& options);

}  // namespace demolish
