// SPDX-License-Identifier: Apache-2.0
// What sets are made of, for the determinism and parity tests: things that are held, led, in mortar, and dry.
#pragma once
#include "sim_cuda/api/solver.h"

namespace demolish::tests {

/// A column that is held in the ground, and a hammer that a path swings through it.
SceneSetup heldScene();
/// A wall of two materials in mortar, every other course of headers, that an iron ball meets.
SceneSetup mortarScene();
/// The same wall without mortar.
SceneSetup dryScene();

}  // namespace demolish::tests
