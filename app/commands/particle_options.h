// SPDX-License-Identifier: Apache-2.0
// Options to what a body is cut into: how many particles, how laid out, how strong, how stepped.
#pragma once
#include "app/commands/shot_options.h"

namespace demolish {

/// Part of addShotOptions().
void addParticleOptions(CLI::App& command, ShotOptions& options);
/// Part of makeShot(). Throws UsageError.
void applyParticles(const ShotOptions& options, Shot& shot);

}  // namespace demolish
