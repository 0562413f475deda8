// SPDX-License-Identifier: Apache-2.0
// Key bindings; silent while a text field has the keyboard.
#include "app/panel/shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/panel/input_events.h"

namespace demolish {
namespace {

bool pressed(int key, int keypad = -1) {
    return keyPressed(key) || (keypad >= 0 && keyPressed(keypad));
}

void lookAlong(engine::Camera& camera, const CameraHome& home, glm::vec3 direction) {
    const float distance = glm::length(camera.eye - camera.target);
    camera.target = home.centre;
    camera.eye = home.centre - distance * glm::normalize(direction);
    camera.up = {0, 1, 0};
}

void handleViews(engine::Camera& camera, const CameraHome& home) {
    if (pressed(GLFW_KEY_F) || pressed(GLFW_KEY_A) || pressed(GLFW_KEY_HOME, GLFW_KEY_KP_DECIMAL))
        camera.frame(home.centre, home.radius);
    if (pressed(GLFW_KEY_0, GLFW_KEY_KP_0)) camera = home.shot_camera;
    if (pressed(GLFW_KEY_1, GLFW_KEY_KP_1)) lookAlong(camera, home, {0, 0, -1});
    if (pressed(GLFW_KEY_3, GLFW_KEY_KP_3)) lookAlong(camera, home, {-1, 0, 0});
    // Not straight down: the camera's up is y.
    if (pressed(GLFW_KEY_7, GLFW_KEY_KP_7)) lookAlong(camera, home, {0, -1, -0.02f});
}

}  // namespace

void handleShortcuts(PanelContext& context, engine::Camera& camera, const CameraHome& home) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    if (pressed(GLFW_KEY_TAB)) context.state.show_panels = !context.state.show_panels;
    if (pressed(GLFW_KEY_SLASH) && io.KeyShift) context.state.show_help = !context.state.show_help;
    if (pressed(GLFW_KEY_ESCAPE)) context.state.show_help = false;
    if (pressed(GLFW_KEY_SPACE)) context.commands.emplace_back(command::TogglePlay{});
    if (pressed(GLFW_KEY_R)) context.commands.emplace_back(command::Reset{});
    if (pressed(GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER)) context.commands.emplace_back(command::Fire{});
    if (keyPressed(GLFW_KEY_RIGHT, true)) context.commands.emplace_back(command::Step{});
    if (keyPressed(GLFW_KEY_LEFT, true) && context.status.cursor > 0)
        context.commands.emplace_back(command::Scrub{context.status.cursor - 1});
    handleViews(camera, home);
}

}  // namespace demolish
