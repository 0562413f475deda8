// SPDX-License-Identifier: Apache-2.0
// The real window program under Xvfb, driven by a script: what it says of itself, and its screenshots.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {

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

    void run(const std::string& script, std::vector<std::string> more = {}, int particles = 300) {
        const auto file = folder_.write("script.txt", withPaths(script));
        std::vector<std::string> words = {"view",      scene_,  "--particles", std::to_string(particles),
                                          "--device",  "cpu",   "--size",      "900x640",
                                          "--quality", "draft", "--no-vsync",  "--script",
                                          file};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramRun result =
            runProgram(words, {"LIBGL_ALWAYS_SOFTWARE=1", "XDG_CACHE_HOME=" + folder_.path().string()},
                       {"xvfb-run", "-a", "-s", "-screen 0 1280x800x24"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    /// "state NAME" and "screenshot NAME" get their files.
    std::string withPaths(const std::string& script) const {
        std::istringstream lines(script);
        std::string text;
        for (std::string line; std::getline(lines, line);) {
            const size_t space = line.find(' ');
            const std::string word = line.substr(0, space),
                              name = line.substr(std::min(line.size(), space + 1));
            if (word == "state") line = "state " + state(name);
            if (word == "screenshot") line = "screenshot " + screenshot(name);
            text += line + "\n";
        }
        return text;
    }
    std::string state(const std::string& name) const { return (folder_.path() / (name + ".json")).string(); }
    nlohmann::json read(const std::string& name) const {
        return nlohmann::json::parse(readText(state(name)));
    }
    std::string screenshot(const std::string& name) const {
        return (screenshots_ / (name + ".png")).string();
    }

    TemporaryFolder folder_;
    std::string scene_ = "block";
    const fs::path screenshots_ = DEMOLISH_SCREENSHOTS;
};

}  // namespace demolish::test
