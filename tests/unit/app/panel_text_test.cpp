// SPDX-License-Identifier: Apache-2.0
// Texts of the panels fit their places: no two are written over each other, and none is cut at its side. Read
// from what Dear ImGui would draw, without a window.
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/panel/gui.h"
#include "app/panel/layout.h"
#include "app/session/scene_file.h"

namespace demolish {
namespace {

constexpr const char* kPackagedFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

struct Glyph {
    float left = 0, top = 0, right = 0, bottom = 0;
    bool is_cut = false;
};

float overlap(float low_a, float high_a, float low_b, float high_b) {
    return std::max(0.0f, std::min(high_a, high_b) - std::max(low_a, low_b));
}

/// More than the edges, which are smoothed: letters stand over each other.
bool cover(const Glyph& a, const Glyph& b) {
    const float wide = overlap(a.left, a.right, b.left, b.right),
                high = overlap(a.top, a.bottom, b.top, b.bottom);
    return wide > 0.4f * std::min(a.right - a.left, b.right - b.left) &&
           high > 0.4f * std::min(a.bottom - a.top, b.bottom - b.top);
}

/// Four corners of a letter in the order that ImFont writes them; areas and lines have one texel, or a row.
bool isGlyph(const ImDrawVert* corner) {
    return corner[0].uv.x < corner[2].uv.x && corner[0].uv.y < corner[2].uv.y &&
           corner[1].uv.y == corner[0].uv.y && corner[3].uv.x == corner[0].uv.x &&
           corner[0].pos.x < corner[2].pos.x && corner[0].pos.y < corner[2].pos.y;
}

std::vector<Glyph> glyphsOf(const ImDrawList& list) {
    std::vector<Glyph> glyphs;
    for (const ImDrawCmd& command : list.CmdBuffer)
        for (unsigned at = 0; at + 6 <= command.ElemCount; at += 3) {
            const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + at)];
            if (index[1] != index[0] + 1 || index[2] != index[0] + 2 || index[3] != index[0]) continue;
            const ImDrawVert* corner = &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
            if (!isGlyph(corner)) continue;
            Glyph glyph{corner[0].pos.x, corner[0].pos.y, corner[2].pos.x, corner[2].pos.y};
            const ImVec4& clip = command.ClipRect;
            const bool in_sight = glyph.bottom > clip.y && glyph.top < clip.w;
            glyph.is_cut = in_sight && (glyph.left < clip.x - 1 || glyph.right > clip.z + 1);
            if (in_sight) glyphs.push_back(glyph);
        }
    return glyphs;
}

/// What the panels are asked to show: the longest names and largest numbers that there are.
SessionStatus longStatus() {
    SessionStatus status;
    status.device = "NVIDIA GeForce RTX 4090 Laptop GPU";
    status.transfer = "interop";
    status.stats.particles = 4'000'000;
    status.stats.bonds = 30'000'000;
    status.stats.bonds_broken = status.stats.bonds_parted = 12'345'678;
    status.stats.fragments = 123'456;
    status.stats.time = 123.456;
    status.stats.mass = 1234.5;
    status.recorded_frames = status.newest = 12'345;
    status.cursor = 12'345;
    status.bodies = 20;
    status.particle_size = 0.0123;
    return status;
}

struct Screen {
    const char* font;  ///< file, or null for the built-in one
    float width, height, scale;
    bool advanced;
};
void PrintTo(const Screen& screen, std::ostream* out) {
    *out << (screen.font != nullptr ? "packaged" : "built-in") << " font, " << screen.width << "x"
         << screen.height << " x " << screen.scale << (screen.advanced ? ", all settings" : "");
}

class PanelText : public testing::TestWithParam<Screen> {
  protected:
    void SetUp() override {
        const Screen& screen = GetParam();
        std::error_code error;
        if (screen.font != nullptr && !std::filesystem::exists(screen.font, error))
            GTEST_SKIP() << screen.font << " is not installed";
        ImGui::CreateContext();
        made_ = true;
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(screen.width, screen.height);
        addPanelFont(screen.font == nullptr ? "" : screen.font, screen.scale);
        setPanelTheme(screen.scale);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    void TearDown() override {
        if (made_) ImGui::DestroyContext();
    }
    /// The frames before settle sizes and scrolling.
    void show(SessionStatus status) {
        Shot shot = loadScene("bunny");
        shot.bodies.resize(12);
        for (SceneBody& body : shot.bodies) body.name = "plinth of the statue";
        const Shot preset = shot;
        FrameHistory history;
        FrameSample sample;
        sample.frame_ms = 123.4;
        for (int i = 0; i < 30; ++i) history.add(sample);
        const std::string renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
        const std::vector<std::string> scenes{"bunny", "wolf"}, materials{"ceramic", "concrete"};
        ViewSettings view;
        PanelState state;
        state.advanced = GetParam().advanced;
        state.open_report = true;
        state.chosen_body = 1;
        ItemRegistry items;
        std::vector<command::Any> commands;
        for (int frame = 0; frame < 3; ++frame) {
            PanelContext context{shot, preset, status, history,  renderer, scenes, materials,
                                 view, state,  items,  commands, false,    {},     {}};
            context.report = {{"model", "/home/artist/projects/museum/statue_of_the_queen_final.glb"},
                              {"holds", "1234567 triangles, 123 parts, 4567 open edges"}};
            ImGui::NewFrame();
            showPanels(context);
            ImGui::Render();
        }
    }

  private:
    bool made_ = false;
};

TEST_P(PanelText, FitsItsPlace) {
    show(longStatus());
    const ImDrawData& data = *ImGui::GetDrawData();
    size_t seen = 0;
    for (int k = 0; k < data.CmdListsCount; ++k) {
        const std::vector<Glyph> glyphs = glyphsOf(*data.CmdLists[k]);
        seen += glyphs.size();
        for (size_t i = 0; i < glyphs.size(); ++i) {
            EXPECT_FALSE(glyphs[i].is_cut) << "at " << glyphs[i].left << ", " << glyphs[i].top;
            for (size_t j = i + 1; j < glyphs.size(); ++j)
                EXPECT_FALSE(cover(glyphs[i], glyphs[j])) << "at " << glyphs[i].left << ", " << glyphs[i].top;
        }
    }
    EXPECT_GT(seen, 300u) << "letters";
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, PanelText,
    testing::Values(Screen{kPackagedFont, 1280, 720, 1, true}, Screen{nullptr, 1280, 720, 1, true},
                    Screen{kPackagedFont, 1500, 850, 1, false}, Screen{nullptr, 1500, 850, 1, false},
                    Screen{kPackagedFont, 1920, 1080, 1, true}, Screen{nullptr, 1920, 1080, 1, true},
                    Screen{kPackagedFont, 3840, 2160, 2, true}, Screen{nullptr, 3840, 2160, 2, true}));

}  // namespace
}  // namespace demolish
