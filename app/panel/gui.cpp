// SPDX-License-Identifier: Apache-2.0
// Set-up of Dear ImGui with its GLFW and OpenGL 3 backends.
#include "app/panel/gui.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <filesystem>

#include "app/session/data_folder.h"

namespace demolish {
namespace {

/// DejaVu (legible at every scale) where the bundle or the system has it, else "".
std::string fontFile() {
    for (const std::filesystem::path& font :
         {dataFolder() / "fonts" / "DejaVuSans.ttf",
          std::filesystem::path("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")}) {
        std::error_code error;
        if (std::filesystem::exists(font, error)) return font.string();
    }
    return "";
}

}  // namespace

void addPanelFont(const std::string& file, float scale) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    if (!file.empty()) {
        fonts.AddFontFromFileTTF(file.c_str(), 14.0f * scale);
        return;
    }
    ImFontConfig config;
    config.SizePixels = 13.0f * scale;
    fonts.AddFontDefault(&config);
}

void setPanelTheme(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 0;
    style.FramePadding = ImVec2(6, 3);
    style.ItemSpacing = ImVec2(7, 4);
    const auto set = [&style](ImGuiCol id, float r, float g, float b) {
        style.Colors[id] = ImVec4(r, g, b, 1);
    };
    set(ImGuiCol_WindowBg, 0.115f, 0.12f, 0.135f);
    set(ImGuiCol_PopupBg, 0.15f, 0.155f, 0.17f);
    set(ImGuiCol_FrameBg, 0.20f, 0.21f, 0.235f);
    set(ImGuiCol_FrameBgHovered, 0.25f, 0.265f, 0.30f);
    set(ImGuiCol_FrameBgActive, 0.29f, 0.31f, 0.35f);
    set(ImGuiCol_Header, 0.17f, 0.20f, 0.245f);
    set(ImGuiCol_HeaderHovered, 0.22f, 0.27f, 0.34f);
    set(ImGuiCol_HeaderActive, 0.25f, 0.31f, 0.40f);
    set(ImGuiCol_Button, 0.21f, 0.30f, 0.42f);
    set(ImGuiCol_ButtonHovered, 0.27f, 0.39f, 0.55f);
    set(ImGuiCol_ButtonActive, 0.33f, 0.48f, 0.68f);
    set(ImGuiCol_SliderGrab, 0.42f, 0.60f, 0.84f);
    set(ImGuiCol_SliderGrabActive, 0.55f, 0.74f, 1.0f);
    set(ImGuiCol_CheckMark, 0.55f, 0.74f, 1.0f);
    set(ImGuiCol_Text, 0.92f, 0.93f, 0.95f);
    set(ImGuiCol_TextDisabled, 0.62f, 0.65f, 0.70f);
    style.ScaleAllSizes(scale);
}

Gui::Gui(GLFWwindow* window, float scale) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // no file appears where the program is started
    addPanelFont(fontFile(), scale);
    setPanelTheme(scale);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::beginFrame(const std::function<void()>& inject) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (inject) inject();
    ImGui::NewFrame();
}

void Gui::endFrame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace demolish
