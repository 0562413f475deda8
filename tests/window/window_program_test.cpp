// Drives the real window program under Xvfb: moves both live sliders, fires, resets, scrubs; checks what it
// says of itself and keeps screenshots.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

namespace fs = std::filesystem;

/// One run of the window program by a script.
class WindowProgram : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
        if (std::system("command -v xvfb-run > /dev/null 2>&1") != 0)
            GTEST_SKIP() << "xvfb-run is missing (package xvfb)";
        fs::create_directories(screenshots_);
    }

    void run(const std::string& script, std::vector<std::string> more = {}) {
        const auto file = folder_.write("script.txt", script);
        std::vector<std::string> words = {"view",       "block",    "--particles", "300",       "--device",
                                          "cpu",        "--size",   "900x640",     "--quality", "draft",
                                          "--no-vsync", "--script", file};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun result =
            runProgram(words, {"LIBGL_ALWAYS_SOFTWARE=1"}, {"xvfb-run", "-a", "-s", "-screen 0 1280x800x24"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    std::string state(const std::string& name) const { return (folder_.path() / (name + ".json")).string(); }
    nlohmann::json read(const std::string& name) const {
        return nlohmann::json::parse(readText(state(name)));
    }
    std::string screenshot(const std::string& name) const {
        return (screenshots_ / (name + ".png")).string();
    }

    TemporaryFolder folder_;
    const fs::path screenshots_ = DEMOLISH_SCREENSHOTS;
};

TEST_F(WindowProgram, SlidersFireAndReset) {
    run("wait 3\n"
        "key space\n"  // pause
        "key r\n"
        "state " +
        state("start") +
        "\n"
        "screenshot " +
        screenshot("1_start") +
        "\n"
        "set impact.velocity 0.75\n"
        "state " +
        state("velocity") +
        "\n"
        "set particles.size 0.62\n"
        "wait 2\n"
        "screenshot " +
        screenshot("2_rebuilding") +
        "\n"
        "until rebuilt\n"
        "wait 2\n"
        "state " +
        state("size") +
        "\n"
        "screenshot " +
        screenshot("3_rebuilt") +
        "\n"
        "click transport.real_time\n"
        "click transport.play\n"
        "wait 16\n"
        "click impact.fire\n"
        "wait 3\n"
        "click transport.play\n"
        "state " +
        state("broken") +
        "\n"
        "screenshot " +
        screenshot("4_broken") +
        "\n"
        "set transport.timeline 0.3\n"
        "state " +
        state("scrubbed") +
        "\n"
        "screenshot " +
        screenshot("5_scrubbed") +
        "\n"
        "click transport.reset\n"
        "state " +
        state("reset") +
        "\n"
        "screenshot " +
        screenshot("6_reset") + "\n");
    if (HasFatalFailure()) return;

    const auto start = read("start"), velocity = read("velocity"), size = read("size"),
               broken = read("broken"), scrubbed = read("scrubbed"), reset = read("reset");
    EXPECT_EQ(start["bonds_broken"], 0);
    EXPECT_EQ(start["playing"], false);
    EXPECT_EQ(start["impact_velocity"], 25.0);
    // Three quarters along a slider of 0..60 m/s, less the width of its grab.
    EXPECT_NEAR(velocity["impact_velocity"].get<double>(), 45, 2);
    EXPECT_EQ(velocity["particles"], start["particles"]) << "velocity must not rebuild";
    EXPECT_NE(size["particles"], start["particles"]);
    EXPECT_NE(size["particle_size"], start["particle_size"]);
    EXPECT_EQ(size["impact_velocity"], velocity["impact_velocity"])
        << "the rebuild keeps the chosen velocity";
    EXPECT_GT(broken["bonds_broken"].get<int>(), 0);
    EXPECT_GT(broken["time"].get<double>(), 0.1);
    EXPECT_EQ(broken["projectiles"], 2) << "the shot's own ball and the one fired";
    EXPECT_GT(broken["recorded_frames"].get<int>(), 10);
    EXPECT_EQ(scrubbed["replaying"], true);
    EXPECT_LT(scrubbed["time"].get<double>(), broken["time"].get<double>());
    EXPECT_EQ(reset["bonds_broken"], 0);
    EXPECT_EQ(reset["time"], 0.0);
    EXPECT_EQ(reset["projectiles"], 1);
    EXPECT_EQ(reset["message"], "");

    const auto whole = engine::readPng(screenshot("3_rebuilt")),
               pieces = engine::readPng(screenshot("4_broken"));
    EXPECT_EQ(whole.width, 900);
    EXPECT_LT(engine::compare(pieces, whole).ssim, 0.98) << "breaking must show in the picture";
}

TEST_F(WindowProgram, LimitsHoldWhenTyping) {
    run("wait 2\n"
        "type impact.velocity 5000\n"
        "state " +
        state("high") +
        "\n"
        "type impact.velocity 7.5\n"
        "state " +
        state("typed") +
        "\n"
        "type impact.velocity -3\n"
        "state " +
        state("low") + "\n");
    if (HasFatalFailure()) return;
    EXPECT_EQ(read("high")["impact_velocity"], 60.0);
    EXPECT_NEAR(read("typed")["impact_velocity"].get<double>(), 7.5, 1e-5);
    EXPECT_EQ(read("low")["impact_velocity"], 0.0);
}

TEST_F(WindowProgram, ViewModeAndMaterialAreChosenFromLists) {
    run("wait 2\n"
        "key space\n"
        "screenshot " +
        screenshot("11_surface") +
        "\n"
        "click view.mode\n"
        "click view.mode.Particles\n"
        "click material.preset\n"
        "click material.preset.glass\n"
        "wait 2\n"
        "until rebuilt\n"
        "wait 2\n"
        "state " +
        state("glass") +
        "\n"
        "screenshot " +
        screenshot("12_particles") + "\n");
    if (HasFatalFailure()) return;
    EXPECT_EQ(read("glass")["material"], "glass");
    EXPECT_EQ(read("glass")["particles"], 300) << "a material makes no new cells";
    const auto surface = engine::readPng(screenshot("11_surface")),
               spheres = engine::readPng(screenshot("12_particles"));
    EXPECT_FALSE(engine::compare(surface, spheres).passed);
}

TEST_F(WindowProgram, ClickShootsKeysAndCameraWork) {
    run("wait 2\n"
        "key r\n"
        "screenshot " +
            screenshot("7_before_orbit") +
            "\n"
            "drag_picture 0.5 0.5 0.7 0.6\n"
            "wait 2\n"
            "screenshot " +
            screenshot("8_after_orbit") +
            "\n"
            "state " +
            state("before") +
            "\n"
            "click_picture 0.5 0.5\n"
            "wait 2\n"
            "state " +
            state("shot") +
            "\n"
            "key question\n"
            "wait 2\n"
            "screenshot " +
            screenshot("9_keys") +
            "\n"
            "key escape\n"
            "key tab\n"
            "wait 2\n"
            "screenshot " +
            screenshot("10_no_panels") + "\n",
        {"--impact-velocity", "10"});
    if (HasFatalFailure()) return;
    EXPECT_EQ(read("before")["projectiles"], 1);
    EXPECT_EQ(read("shot")["projectiles"], 2);
    const auto before = engine::readPng(screenshot("7_before_orbit")),
               after = engine::readPng(screenshot("8_after_orbit"));
    EXPECT_FALSE(engine::compare(before, after).passed) << "the camera did not move";
}

}  // namespace
}  // namespace demolish::test
