// SPDX-License-Identifier: Apache-2.0
// The lines of a check on stdout, its JSON where asked for, its verdict as exit code.
#include "app/commands/check_command.h"

#include <malloc.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/help_text.h"
#include "app/commands/model_options.h"
#include "app/session/json_text.h"
#include "app/session/model_check.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

/// Of a model of a million triangles the system would clear the same pages again and again; the program ends
/// with its answer, so that nobody misses them.
void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kKept = 256 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, kKept);
    mallopt(M_TRIM_THRESHOLD, kKept);
#endif
}

void runCheck(const CheckOptions& options) {
    keepFreedMemory();
    if (!options.json.empty()) requireWritable(options.json);
    const ModelCheck check = checkModel(makeShot(options.shot));
    if (!options.json.empty()) writeTextFile(options.json, jsonText(checkJson(check), 2) + "\n");
    for (const auto& [label, text] : checkLines(check))
        std::printf("%-13s %s\n", label.c_str(), text.c_str());
    if (!check.refusal.empty()) throw InputFileError(check.refusal);
}

}  // namespace

void addCheckCommand(CLI::App& app, CheckOptions& options) {
    auto* command = app.add_subcommand(
        "check", "What a model file holds, what is done to close it, whether it will break (exit 0 or 3)");
    command->add_option("file", options.shot.model, "Model file")->type_name("FILE")->required();
    command
        ->add_option("--height", options.shot.height,
                     "Scale the model to this height (the file's size, or 1 m)")
        ->type_name("M");
    addModelOptions(*command, options.shot);
    command->add_option("--particles", options.shot.particles, "Particles to cut it into (1,200)")
        ->type_name("N");
    command->add_option("--json", options.json, "Write the same as JSON")->type_name("FILE");
    setExamples(*command, {"check statue.obj", "check leaf.glb --thickness 0.01 --json leaf.json"});
    command->callback([&options] { runCheck(options); });
}

}  // namespace demolish
