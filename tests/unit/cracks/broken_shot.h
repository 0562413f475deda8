// SPDX-License-Identifier: Apache-2.0
// A shot simulated on the CPU, and its cracks as they come to be drawn frame by frame.
#pragma once
#include <memory>

#include "tests/physics/scenes/scene_run.h"
#include "tests/unit/draw/drawn_surface.h"

namespace demolish::test {

/// `seconds` of the shot. Every frame is shown, since the look of a crack depends on when it opened.
std::unique_ptr<DrawnSurface> drawnShot(const Shot& shot, double seconds);

}  // namespace demolish::test
