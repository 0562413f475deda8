// SPDX-License-Identifier: Apache-2.0
// Keys by GLFW's codes and input by script, whichever Dear ImGui the system has: up to 1.86 (Debian 12) it
// numbers keys as its backend does and lets anybody write its input state; later ones (Ubuntu 24.04 has 1.90)
// name keys themselves and take events.
#pragma once

namespace demolish {

/// Went down in this frame; with `repeat`, also while it is held. `glfw_key`: one that the program binds.
bool keyPressed(int glfw_key, bool repeat = false);

/// What mouse and keyboard hold during one frame.
struct HeldInput {
    float x = 0, y = 0;  ///< display coordinates
    bool left = false, middle = false, ctrl = false, shift = false;
    int key = -1;  ///< GLFW's code; -1: none
};
/// Between the backends' NewFrame and ImGui::NewFrame: `now` is what the coming frame sees, `before` what the
/// last one saw.
void holdInput(const HeldInput& now, const HeldInput& before);

}  // namespace demolish
