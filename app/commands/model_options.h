// SPDX-License-Identifier: Apache-2.0
// The options that say how a model file is read and how large it is.
#pragma once
#include "app/commands/shot_options.h"
#include "app/session/set_scene.h"

namespace demolish {

/// What of its model file is meant. Throws UsageError for a unit of a file that says its own.
ModelPart modelPart(const ShotOptions& options);
/// Throws UsageError where both --height and --unit are given.
void requireOneSize(const ShotOptions& options);
/// How large a set of it is. Throws UsageError for that, and for a height that is out of range or beside a
/// unit.
SetSize setSize(const ShotOptions& options);

/// --up and --unit; part of addModelOptions().
void addLengthOptions(CLI::App& command, ShotOptions& options);
/// How a model file is read: --node, --up, --unit, --repair and --thickness; part of addShotOptions().
void addModelOptions(CLI::App& command, ShotOptions& options);

}  // namespace demolish
