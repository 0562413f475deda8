// SPDX-License-Identifier: Apache-2.0
// The two ways of Dear ImGui to say which keys are down.
#include "app/panel/input_events.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace demolish {

#if IMGUI_VERSION_NUM >= 18900

namespace {

ImGuiKey nameOf(int key) {
    const auto following = [key](ImGuiKey first, int glfw_first) {
        return static_cast<ImGuiKey>(static_cast<int>(first) + key - glfw_first);
    };
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return following(ImGuiKey_A, GLFW_KEY_A);
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return following(ImGuiKey_0, GLFW_KEY_0);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return following(ImGuiKey_Keypad0, GLFW_KEY_KP_0);
    switch (key) {
        case GLFW_KEY_SPACE:
            return ImGuiKey_Space;
        case GLFW_KEY_TAB:
            return ImGuiKey_Tab;
        case GLFW_KEY_SLASH:
            return ImGuiKey_Slash;
        case GLFW_KEY_ESCAPE:
            return ImGuiKey_Escape;
        case GLFW_KEY_ENTER:
            return ImGuiKey_Enter;
        case GLFW_KEY_KP_ENTER:
            return ImGuiKey_KeypadEnter;
        case GLFW_KEY_KP_DECIMAL:
            return ImGuiKey_KeypadDecimal;
        case GLFW_KEY_HOME:
            return ImGuiKey_Home;
        case GLFW_KEY_LEFT:
            return ImGuiKey_LeftArrow;
        case GLFW_KEY_RIGHT:
            return ImGuiKey_RightArrow;
        default:
            return ImGuiKey_None;
    }
}

}  // namespace

bool keyPressed(int glfw_key, bool repeat) {
    return ImGui::IsKeyPressed(nameOf(glfw_key), repeat);
}

void holdInput(const HeldInput& now, const HeldInput& before) {
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigInputTrickleEventQueue = false;  // all of it in the coming frame, as it is in a state
    io.AddMousePosEvent(now.x, now.y);
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, now.left);
    io.AddMouseButtonEvent(ImGuiMouseButton_Middle, now.middle);
    io.AddKeyEvent(ImGuiMod_Ctrl, now.ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, now.shift);
    if (before.key >= 0 && before.key != now.key) io.AddKeyEvent(nameOf(before.key), false);
    if (now.key >= 0) io.AddKeyEvent(nameOf(now.key), true);
}

#else

bool keyPressed(int glfw_key, bool repeat) {
    return ImGui::IsKeyPressed(glfw_key, repeat);
}

void holdInput(const HeldInput& now, const HeldInput&) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(now.x, now.y);
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    io.MouseDown[ImGuiMouseButton_Left] = now.left;
    io.MouseDown[ImGuiMouseButton_Middle] = now.middle;
    io.KeyCtrl = now.ctrl;
    io.KeyShift = now.shift;
    io.KeyAlt = false;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    if (now.key >= 0) io.KeysDown[now.key] = true;
}

#endif

}  // namespace demolish
