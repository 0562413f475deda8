// SPDX-License-Identifier: Apache-2.0
// Killed at any moment, the program leaves no half file under its final name, and the next run ends well.
// DEMOLISH_KILLS: how often each command is killed, 2 if it is not set.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/image/png.h"
#include "tests/fuzz/support/child_program.h"
#include "tests/fuzz/support/dice.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::fuzz {
namespace {

namespace fs = std::filesystem;
using test::readText;

constexpr double kPatience = 300;  // s

size_t kills() {
    const char* wanted = std::getenv("DEMOLISH_KILLS");
    return wanted != nullptr ? std::strtoul(wanted, nullptr, 10) : 2;
}

struct Command {
    const char* name;
    std::vector<std::string> words;          ///< relative names are made in the run's folder
    std::vector<std::string> results;        ///< that a whole run leaves
    std::vector<std::string> same_each_run;  ///< of these, those that are the same to the last bit
};

void PrintTo(const Command& command, std::ostream* out) {
    *out << command.name;
}

bool endsWell(const fs::path& file) {
    const auto extension = file.extension();
    if (extension == ".json") return nlohmann::json::accept(readText(file));
    if (extension == ".mp4")  // decoded to its end: the head of a film that is cut reads well
        return runChild({"ffmpeg", "-v", "error", "-xerror", "-i", file.string(), "-f", "null", "-"},
                        {.seconds = kPatience})
            .endedWith(0);
    if (extension == ".svg") return readText(file).find("</svg>") != std::string::npos;
    if (extension == ".csv") return readText(file).ends_with('\n');
    if (extension != ".png") return true;
    try {
        return engine::readPng(file).width > 0;
    } catch (const engine::ImageError&) {
        return false;
    }
}

/// Says so in its name (engine/image/unfinished_file.h).
bool isUnfinished(const fs::path& file) {
    return file.filename().string().starts_with(".demolish.");
}

class Kill : public testing::TestWithParam<Command> {
  protected:
    void SetUp() override {
        if (test::programPath().empty())
            GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
        folder_.write("tiny.toml",
                      "[specimen]\ngrains = 40\npackings = 2\n[impact]\nslowest_mps = 10\n"
                      "fastest_mps = 90\nvelocities = 3\nduration_s = 40e-9\n");
    }
    fs::path folder(const std::string& name) const { return folder_.path() / name; }
    /// In a folder of this name, with a cache of its own.
    ChildEnd run(const std::string& name, double kill_after = 0) const {
        fs::create_directories(folder(name));
        std::vector<std::string> words = {"env", "-C", folder(name).string(), test::programPath()};
        words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
        return runChild(words, {.seconds = kPatience, .kill_after = kill_after},
                        {"XDG_CACHE_HOME=" + (folder(name) / "cache").string()});
    }
    void expectWholeFiles(const std::string& name) const {
        for (const auto& entry : fs::recursive_directory_iterator(folder(name)))
            if (entry.is_regular_file() && !isUnfinished(entry.path())) {
                EXPECT_TRUE(endsWell(entry.path())) << "half a file: " << entry.path();
            }
    }
    void expectNothingUnfinished(const std::string& name) const {
        for (const auto& entry : fs::recursive_directory_iterator(folder(name)))
            EXPECT_FALSE(isUnfinished(entry.path())) << entry.path() << " is left for ever";
    }
    void expectResults(const std::string& name) const {
        for (const auto& result : GetParam().results)
            EXPECT_TRUE(fs::exists(folder(name) / result)) << result;
        for (const auto& result : GetParam().same_each_run)
            EXPECT_EQ(readText(folder(name) / result), readText(folder("whole") / result)) << result;
    }
    test::TemporaryFolder folder_;
};

TEST_P(Kill, LeavesNoHalfFileAndTheNextRunEndsWell) {
    const ChildEnd whole = run("whole");
    ASSERT_TRUE(whole.endedWith(0)) << describe(whole) << whole.err;
    expectWholeFiles("whole");
    expectResults("whole");
    Dice dice(7, whole.out.size());
    for (size_t k = 0; k < kills(); ++k) {
        const std::string name = "killed_" + std::to_string(k);
        const double moment = dice.uniform(0, whole.seconds);
        SCOPED_TRACE("killed after " + std::to_string(moment) + " s of " + std::to_string(whole.seconds));
        if (k % 3 == 2) run(name);  // over what an earlier run has left
        run(name, moment);
        expectWholeFiles(name);
        const ChildEnd next = run(name);
        EXPECT_TRUE(next.endedWith(0)) << describe(next) << next.err;
        expectWholeFiles(name);
        expectNothingUnfinished(name);
        expectResults(name);
    }
}

/// Cut anywhere, a file of each kind is seen to be half.
TEST_P(Kill, HalfFilesAreNoticed) {
    const ChildEnd whole = run("whole");
    ASSERT_TRUE(whole.endedWith(0)) << describe(whole) << whole.err;
    for (const auto& result : GetParam().results) {
        const fs::path file = folder("whole") / result;
        ASSERT_TRUE(endsWell(file)) << file;
        fs::resize_file(file, fs::file_size(file) / 2);
        EXPECT_FALSE(endsWell(file)) << file;
    }
}

const std::vector<Command> kCommands = {
    {"capture",
     {"capture", "block", "--particles", "150", "--frames", "10", "--size", "160x90", "--device", "cpu",
      "--quality", "draft", "--out", "frames", "--video", "film.mp4", "--report", "report.json"},
     {"frames/contact_sheet.png", "film.mp4", "report.json"},
     {"frames/frame_0000.png", "frames/frame_0009.png"}},
    {"calibrate",
     {"calibrate", "block", "--particles", "60", "--device", "cpu", "--drop", "5", "--packings", "2",
      "--json", "threshold.json"},
     {"threshold.json"},
     {}},
    {"breakage",
     {"breakage", "../tiny.toml", "--device", "cpu", "--full", "--batch", "2", "--out", "results"},
     {"results/figure_1.svg"},
     {"results/plan.json", "results/specimens.csv", "results/probability.csv", "results/breakage.json"}}};

INSTANTIATE_TEST_SUITE_P(Commands, Kill, testing::ValuesIn(kCommands),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace demolish::fuzz
