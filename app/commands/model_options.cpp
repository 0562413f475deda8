// SPDX-License-Identifier: Apache-2.0
#include "app/commands/model_options.h"

#include <CLI/CLI.hpp>

#include "app/session/model_shot.h"
#include "sim_cuda/api/errors.h"

namespace demolish {

ModelPart modelPart(const ShotOptions& options) {
    const double unit = lengthUnitOf(options.unit).value_or(0);
    if (const std::string refusal = unit > 0 ? refusalOfUnit(options.model) : ""; !refusal.empty())
        throw UsageError("--unit is for files that do not say theirs: " + refusal +
                         "; leave it out, or scale the model by --height");
    return {options.node, options.up == "z" ? UpAxis::kZ : UpAxis::kY, unit};
}

void requireOneSize(const ShotOptions& options) {
    if (options.height && !options.unit.empty())
        throw UsageError(
            "--height and --unit exclude each other: one scales the model, the other keeps its size");
}

SetSize setSize(const ShotOptions& options) {
    requireOneSize(options);
    if (options.height) requireInRange("--height", *options.height, kHeightRange, "m");
    return {modelPart(options), options.height};
}

void addLengthOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("--up", options.up, "Axis of the model file that points up (y)")
        ->type_name("y|z")
        ->check(CLI::IsMember({"y", "z"}).description(""));
    command
        .add_option("--unit", options.unit,
                    "Of the model file, where its format says none: it keeps its size")
        ->type_name("m|cm|mm|in|ft")
        ->check(CLI::IsMember(lengthUnitNames()).description(""));
}

void addModelOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("--node", options.node, "Break this node of the model file alone")->type_name("NAME");
    addLengthOptions(command, options);
    command
        .add_option("--repair", options.repair,
                    "How a model that is not closed is made one; exact: never with a new surface")
        ->type_name("auto|exact|remesh|off")
        ->check(CLI::IsMember(repairModeNames()).description(""));
    command
        .add_option("--thickness", options.thickness,
                    "Of sheets, surfaces without an inside (default: by their area)")
        ->type_name("M");
}

}  // namespace demolish
