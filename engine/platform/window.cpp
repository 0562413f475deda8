// SPDX-License-Identifier: Apache-2.0
// GLFW behind the GlContext interface. GLFW is started once for all windows and left to the end of the
// process.
#include "engine/platform/window.h"

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE  // glad declares GL
#include <GLFW/glfw3.h>

#include "engine/gl/error.h"

namespace demolish::engine {
namespace {

std::string lastGlfwError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

bool startGlfw(std::string* reason) {
    static const bool started = glfwInit() == GLFW_TRUE;
    static const std::string failure = started ? "" : lastGlfwError();
    if (reason != nullptr) *reason = failure;
    return started;
}

}  // namespace

struct Window::State {
    GLFWwindow* window = nullptr;
    ContextInfo info;
    WindowEvents events;
    double cursor_x = 0, cursor_y = 0;

    ~State() {
        if (window != nullptr) glfwDestroyWindow(window);
    }

    static State& of(GLFWwindow* handle) { return *static_cast<State*>(glfwGetWindowUserPointer(handle)); }
    static void onKey(GLFWwindow* handle, int key, int, int action, int modifiers) {
        const KeyEvent event{key, modifiers, action != GLFW_RELEASE, action == GLFW_REPEAT};
        if (State& state = of(handle); state.events.on_key) state.events.on_key(event);
    }
    static void onButton(GLFWwindow* handle, int button, int action, int modifiers) {
        State& state = of(handle);
        glfwGetCursorPos(handle, &state.cursor_x, &state.cursor_y);
        const MouseButtonEvent event{button, modifiers, action == GLFW_PRESS, state.cursor_x, state.cursor_y};
        if (state.events.on_mouse_button) state.events.on_mouse_button(event);
    }
    static void onMove(GLFWwindow* handle, double x, double y) {
        State& state = of(handle);
        const MouseMoveEvent event{x, y, x - state.cursor_x, y - state.cursor_y};
        state.cursor_x = x;
        state.cursor_y = y;
        if (state.events.on_mouse_move) state.events.on_mouse_move(event);
    }
    static void onScroll(GLFWwindow* handle, double x, double y) {
        if (State& state = of(handle); state.events.on_scroll) state.events.on_scroll({x, y});
    }
    static void onDrop(GLFWwindow* handle, int count, const char** paths) {
        if (State& state = of(handle); state.events.on_drop) state.events.on_drop({{paths, paths + count}});
    }

    void installCallbacks() {
        glfwSetWindowUserPointer(window, this);
        glfwGetCursorPos(window, &cursor_x, &cursor_y);
        glfwSetKeyCallback(window, onKey);
        glfwSetMouseButtonCallback(window, onButton);
        glfwSetCursorPosCallback(window, onMove);
        glfwSetScrollCallback(window, onScroll);
        glfwSetDropCallback(window, onDrop);
    }
};

Window::Window(const WindowOptions& options) : state_(std::make_unique<State>()) {
    std::string reason;
    if (!startGlfw(&reason)) {
        throw gl::GlError("No window can be opened (" + reason +
                          "); set DISPLAY, use Xvfb, or use 'capture', which needs no display.");
    }
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SAMPLES, 0);  // the renderer resolves its own samples
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    state_->window = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (state_->window == nullptr) {
        throw gl::GlError("No OpenGL 4.5 window (" + lastGlfwError() +
                          "); update the graphics driver, or use 'capture', which needs no display.");
    }
    makeCurrent();
    if (gladLoadGL(glfwGetProcAddress) == 0)
        throw gl::GlError("The OpenGL functions cannot be loaded; reinstall libgl1.");
    state_->info = describeCurrentContext("GLFW window");
    gl::installDebugCallback();
    setVsync(options.vsync);
    state_->installCallbacks();
}

Window::~Window() = default;

void Window::makeCurrent() {
    glfwMakeContextCurrent(state_->window);
}
const ContextInfo& Window::info() const {
    return state_->info;
}
void Window::setEvents(WindowEvents events) {
    state_->events = std::move(events);
}
void Window::pollEvents() {
    glfwPollEvents();
}
void Window::swapBuffers() {
    glfwSwapBuffers(state_->window);
}
bool Window::shouldClose() const {
    return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}
void Window::requestClose() {
    glfwSetWindowShouldClose(state_->window, GLFW_TRUE);
}
void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(state_->window, title.c_str());
}
void Window::setVsync(bool on) {
    glfwSwapInterval(on ? 1 : 0);
}
GLFWwindow* Window::handle() const {
    return state_->window;
}

int Window::framebufferWidth() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(state_->window, &width, &height);
    return width;
}

int Window::framebufferHeight() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(state_->window, &width, &height);
    return height;
}

float Window::contentScale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(state_->window, &x, &y);
    return x;
}

bool Window::available(std::string* reason) {
    return startGlfw(reason);
}

}  // namespace demolish::engine
