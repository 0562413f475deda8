// SPDX-License-Identifier: Apache-2.0
// The window: opens, draws what the headless context draws, and delivers events. Needs a display, if only
// Xvfb.
#include "engine/platform/window.h"

#define GLFW_INCLUDE_NONE  // glad declares GL
#include <GLFW/glfw3.h>
#include <glad/gl.h>
#include <gtest/gtest.h>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (std::string reason; !Window::available(&reason)) GTEST_SKIP() << "no display: " << reason;
    }
};

TEST_F(WindowTest, DrawsTheRenderersPictureIntoTheBackBuffer) {
    WindowOptions options;
    options.width = 320;
    options.height = 180;
    options.vsync = false;
    options.debug = true;
    Window window(options);
    EXPECT_GT(window.contentScale(), 0.0f);
    Renderer renderer(shaderFolder());
    Scene scene = wholeBlock();
    scene.view.width = window.framebufferWidth();
    scene.view.height = window.framebufferHeight();
    const Image expected = drawPicture(renderer, scene);
    renderer.draw(scene.mesh.get(), {}, scene.view, 0);
    uint8_t pixel[4] = {};
    const int x = scene.view.width / 2, y = scene.view.height / 2;
    glReadBuffer(GL_BACK);
    glReadPixels(x, scene.view.height - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(pixel[c], expected.at(x, y)[c]);
    window.swapBuffers();
    EXPECT_FALSE(window.shouldClose());
    window.requestClose();
    EXPECT_TRUE(window.shouldClose());
}

TEST_F(WindowTest, DeliversEventsToTheirReceivers) {
    WindowOptions options;
    options.width = 200;
    options.height = 100;
    Window window(options);
    std::vector<MouseMoveEvent> moves;
    std::vector<MouseButtonEvent> buttons;
    WindowEvents events;
    events.on_mouse_move = [&](const MouseMoveEvent& event) { moves.push_back(event); };
    events.on_mouse_button = [&](const MouseButtonEvent& event) { buttons.push_back(event); };
    window.setEvents(events);
    // GLFW hands out the callbacks that Window installed; calling them is what the display server would
    // cause.
    const GLFWcursorposfun move = glfwSetCursorPosCallback(window.handle(), nullptr);
    const GLFWmousebuttonfun press = glfwSetMouseButtonCallback(window.handle(), nullptr);
    ASSERT_NE(move, nullptr);
    ASSERT_NE(press, nullptr);
    move(window.handle(), 10.0, 20.0);
    move(window.handle(), 14.0, 23.0);
    press(window.handle(), GLFW_MOUSE_BUTTON_MIDDLE, GLFW_PRESS, GLFW_MOD_SHIFT);
    ASSERT_EQ(moves.size(), 2u);
    EXPECT_EQ(moves[1].delta_x, 4.0);
    EXPECT_EQ(moves[1].delta_y, 3.0);
    ASSERT_EQ(buttons.size(), 1u);
    EXPECT_EQ(buttons[0].button, GLFW_MOUSE_BUTTON_MIDDLE);
    EXPECT_EQ(buttons[0].modifiers, GLFW_MOD_SHIFT);
    EXPECT_TRUE(buttons[0].pressed);
}

}  // namespace
}  // namespace demolish::engine::test
