// SPDX-License-Identifier: Apache-2.0
// Dear ImGui's lifetime: context, fonts, theme, one frame.
#pragma once
#include <functional>
#include <string>

struct GLFWwindow;

namespace demolish {

/// The font of the panels: a TrueType file, or Dear ImGui's own bitmap font for "". `scale` as Gui's.
void addPanelFont(const std::string& file, float scale);
/// Colours and distances.
void setPanelTheme(float scale);

class Gui {
  public:
    /// `scale`: the monitor's content scale. Install after the window's own callbacks: ImGui chains to them.
    Gui(GLFWwindow* window, float scale);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// `inject` may change the input of this frame before ImGui sees it (scripts).
    void beginFrame(const std::function<void()>& inject = {});
    /// Draws the panels into the current framebuffer.
    void endFrame();
};

}  // namespace demolish
