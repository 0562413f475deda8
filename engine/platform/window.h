// SPDX-License-Identifier: Apache-2.0
// A GLFW window with an OpenGL 4.5 core context; its events reach the owner as plain structs.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/platform/gl_context.h"

struct GLFWwindow;

namespace demolish::engine {

/// Codes and modifier bits are GLFW's (GLFW_KEY_*, GLFW_MOUSE_BUTTON_*, GLFW_MOD_*). Positions: window units
/// from the top left.
struct KeyEvent {
    int key = 0;
    int modifiers = 0;
    bool pressed = false;  ///< true for press and repeat
    bool repeat = false;
};
struct MouseButtonEvent {
    int button = 0;
    int modifiers = 0;
    bool pressed = false;
    double x = 0, y = 0;
};
struct MouseMoveEvent {
    double x = 0, y = 0;
    double delta_x = 0, delta_y = 0;
};
struct ScrollEvent {
    double x = 0, y = 0;  ///< wheel steps
};
struct DropEvent {
    std::vector<std::string> paths;
};

struct WindowEvents {
    std::function<void(const KeyEvent&)> on_key;
    std::function<void(const MouseButtonEvent&)> on_mouse_button;
    std::function<void(const MouseMoveEvent&)> on_mouse_move;
    std::function<void(const ScrollEvent&)> on_scroll;
    std::function<void(const DropEvent&)> on_drop;
};

struct WindowOptions {
    std::string title = "Demolish";
    int width = 1600, height = 900;  ///< window units
    bool vsync = true;
    bool visible = true;
    bool debug = false;  ///< debug context
};

/// One window; GLFW's callbacks are installed at construction, so a GUI that chains callbacks (ImGui's GLFW
/// backend with install_callbacks = true) may be attached to handle() afterwards. Use from the main thread
/// only.
class Window : public GlContext {
  public:
    /// Current on return. Throws gl::GlError with the remedy when there is no display or no OpenGL 4.5.
    explicit Window(const WindowOptions& options = {});
    ~Window() override;

    void makeCurrent() override;
    const ContextInfo& info() const override;

    void setEvents(WindowEvents events);
    void pollEvents();  ///< runs the callbacks
    void swapBuffers();
    bool shouldClose() const;
    void requestClose();
    void setTitle(const std::string& title);
    void setVsync(bool on);

    int framebufferWidth() const;   ///< px
    int framebufferHeight() const;  ///< px
    float contentScale() const;     ///< px per window unit, of the monitor
    GLFWwindow* handle() const;

    /// False when GLFW finds no display; `reason` then holds GLFW's words.
    static bool available(std::string* reason = nullptr);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace demolish::engine
