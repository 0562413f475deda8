// SPDX-License-Identifier: Apache-2.0
// What --split runs, as a file.
#include "app/commands/scene_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands/help_text.h"
#include "app/commands/model_options.h"
#include "app/session/output_file.h"
#include "app/session/scene_file.h"
#include "app/session/set_scene.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

void runScene(const SceneOptions& options) {
    const std::filesystem::path out(options.out);
    if (out.extension() != ".toml")
        throw UsageError("--out is '" + options.out + "'; the name of a scene ends in .toml");
    std::error_code ignored;
    if (std::filesystem::exists(out, ignored))
        throw OutputError("'" + options.out + "' is there already, perhaps edited; choose another name");
    requireWritable(out);
    const std::string text = sceneTextOf(options.shot.model, setSize(options.shot), out);
    writeTextFile(out, text);
    const Shot shot = loadSceneFile(out);
    const size_t bodies = shot.bodies.size(), colliders = shot.colliders.size();
    std::printf("%zu %s, %zu %s; see it: demolish view %s\n", bodies, bodies == 1 ? "body" : "bodies",
                colliders, colliders == 1 ? "collider" : "colliders", options.out.c_str());
}

}  // namespace

void addSceneCommand(CLI::App& app, SceneOptions& options) {
    auto* command =
        app.add_subcommand("scene", "Write a scene file in which each node of a model file is a body");
    command->add_option("file", options.shot.model, "Model file")->type_name("FILE")->required();
    command->add_option("--out", options.out, "Scene file to write")->type_name("FILE.toml")->required();
    command->add_option("--height", options.shot.height, "Scale the whole set to this height")
        ->type_name("M");
    addLengthOptions(*command, options.shot);
    setExamples(*command, {"scene set.glb --out my_shot.toml", "scene set.glb --height 2 --out small.toml"});
    command->callback([&options] { runScene(options); });
}

}  // namespace demolish
