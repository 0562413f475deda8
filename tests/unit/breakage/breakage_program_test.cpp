// SPDX-License-Identifier: Apache-2.0
// `demolish breakage` as a user meets it: interrupted and resumed, by single items, by several processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kOutputs[] = {"plan.json",    "specimens.csv", "probability.csv", "breakage.json",
                                    "figure_1.svg", "figure_2a.svg", "figure_2b.svg"};

class BreakageProgram : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
        experiment_ = folder_.write("tiny.toml",
                                    "[specimen]\ngrains = 40\npackings = 2\n[impact]\nslowest_mps = 10\n"
                                    "fastest_mps = 90\nvelocities = 2\nduration_s = 40e-9\n");
    }
    ProgramRun run(const std::string& out, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = tiny();
        words.insert(words.end(), {"--out", folder_.path() / out});
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }
    std::vector<std::string> tiny() const {
        return {"breakage", experiment_, "--device", "cpu", "--full", "--batch", "3"};
    }
    std::string text(const std::string& out, const std::string& name) {
        return readText(folder_.path() / out / name);
    }
    void expectSame(const std::string& a, const std::string& b) {
        for (const char* name : kOutputs) {
            EXPECT_FALSE(text(a, name).empty()) << name;
            EXPECT_EQ(text(a, name), text(b, name)) << name;
        }
    }
    TemporaryFolder folder_;
    fs::path experiment_;
};

TEST_F(BreakageProgram, ResumedByItemsAndByProcessesItGivesTheSameBytes) {
    const ProgramRun whole = run("whole");
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_THAT(whole.out, HasSubstr("distance to these four"));
    ASSERT_EQ(
        runProgram({"breakage", experiment_, "--device", "cpu", "--full", "--batch", "3", "--count"}).out,
        "3\n");

    // Interrupted: one item is missing, one torn file of a killed process lies about.
    ASSERT_EQ(run("resumed").exit_code, 0);
    const fs::path items = folder_.path() / "resumed" / "items";
    fs::remove(items / "item_00001.json");
    folder_.write("resumed/items/item_00001.json.4711", "{\"pl");
    const fs::path left_by_killed = folder_.write("resumed/.demolish.1.1", "{\"pl");
    const auto untouched = fs::last_write_time(items / "item_00000.json");
    ASSERT_EQ(run("resumed").exit_code, 0);
    EXPECT_EQ(fs::last_write_time(items / "item_00000.json"), untouched) << "computed again";
    EXPECT_FALSE(fs::exists(left_by_killed));
    expectSame("whole", "resumed");

    for (const char* index : {"2", "0", "1", "1"}) {
        const ProgramRun item = run("array", {"--index", index});
        EXPECT_EQ(item.exit_code, 0) << item.err;
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "array" / "specimens.csv"));
    const fs::path left_by_gather = folder_.write("array/.demolish.1.2", "<svg");
    const ProgramRun gathered = runProgram({"breakage", "gather", "--out", folder_.path() / "array"});
    EXPECT_EQ(gathered.exit_code, 0) << gathered.err;
    EXPECT_FALSE(fs::exists(left_by_gather));
    const std::string table = gathered.out.substr(0, gathered.out.find("written to"));
    EXPECT_THAT(table, HasSubstr("distance to these four"));
    EXPECT_THAT(whole.out, HasSubstr(table));
    expectSame("whole", "array");

    const ProgramRun jobs = run("jobs", {"--jobs", "2"});
    EXPECT_EQ(jobs.exit_code, 0) << jobs.err;
    expectSame("whole", "jobs");
}

TEST_F(BreakageProgram, JobsEndWhereTheParentOfAllIgnoresItsChildren) {
    std::vector<std::string> words = tiny();
    words.insert(words.end(), {"--jobs", "2", "--out", folder_.path() / "ignored"});
    const ProgramRun jobs = runProgram(words, {}, {"timeout", "120", "env", "--ignore-signal=CHLD"});
    EXPECT_EQ(jobs.exit_code, 0) << jobs.err;
    EXPECT_FALSE(text("ignored", "breakage.json").empty());
}

TEST_F(BreakageProgram, AJobThatFailsGivesItsExitCode) {
    ASSERT_EQ(run("taken").exit_code, 0);
    fs::remove(folder_.path() / "taken" / "items" / "item_00001.json");
    std::vector<std::string> words = tiny();
    words.insert(words.end(), {"--jobs", "2", "--out", folder_.path() / "taken"});
    // Files of no bytes at all, which a write is told of as of a full disk.
    const ProgramRun jobs = runProgram(words, {},
                                       {"bash", "-c",
                                        "trap '' XFSZ; (ulimit -f 0; exec \"$@\") 2>&1 > /dev/null | cat "
                                        ">&2; exit ${PIPESTATUS[0]}",
                                        "bash"});
    EXPECT_EQ(jobs.exit_code, 6) << jobs.err;
    EXPECT_THAT(jobs.err, HasSubstr("the same command goes on from there"));
}

/// The width and height that a PNG file's first chunk tells; 0 if it is none.
std::pair<uint32_t, uint32_t> sizeOfPng(const std::string& bytes) {
    if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
    const auto word = [&](size_t at) {
        uint32_t value = 0;
        for (size_t k = at; k < at + 4; ++k) value = 256 * value + static_cast<uint8_t>(bytes[k]);
        return value;
    };
    return {word(16), word(20)};
}

TEST_F(BreakageProgram, FiguresArePicturesToo) {
    if (std::system("rsvg-convert --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no rsvg-convert here";
    const ProgramRun drawn = run("drawn");
    ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_THAT(drawn.out, HasSubstr(".png"));
    for (const char* name : {"figure_1.png", "figure_2a.png", "figure_2b.png"}) {
        const auto [width, height] = sizeOfPng(text("drawn", name));
        EXPECT_EQ(width, 1800u) << name;
        EXPECT_GT(height, 1000u) << name;
    }
    // Folders that look like a URL and an option.
    for (const char* out : {"take:1", "-x"}) {
        std::vector<std::string> words = tiny();
        words.insert(words.end(), {"--jobs", "2", std::string("--out=") + out});
        const ProgramRun named = runProgram(words, {}, {"env", "--chdir", folder_.path()});
        EXPECT_EQ(named.exit_code, 0) << named.err;
        EXPECT_EQ(sizeOfPng(text(out, "figure_1.png")).first, 1800u) << out;
    }
    // A folder in the figure's place.
    fs::remove(folder_.path() / "drawn" / "figure_1.png");
    fs::create_directories(folder_.path() / "drawn" / "figure_1.png" / "inside");
    const ProgramRun blocked = run("drawn");
    EXPECT_EQ(blocked.exit_code, 6);
    EXPECT_THAT(blocked.err, HasSubstr("figure_1.png"));
}

TEST_F(BreakageProgram, WithoutTheProgramThatDrawsThemItSaysSo) {
    ASSERT_EQ(run("plain").exit_code, 0);
    fs::remove(folder_.path() / "plain" / "figure_1.png");
    const ProgramRun again =
        runProgram({"breakage", "gather", "--out", folder_.path() / "plain"}, {"PATH=/nonexistent"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_THAT(again.err, HasSubstr("librsvg2-bin"));
    EXPECT_FALSE(text("plain", "figure_1.svg").empty());
    EXPECT_FALSE(fs::exists(folder_.path() / "plain" / "figure_1.png"));
}

TEST_F(BreakageProgram, MistakesAreOneSentenceAndTheRightCode) {
    const auto expect = [](const ProgramRun& run, int code, const std::string& about) {
        EXPECT_EQ(run.exit_code, code) << run.err;
        EXPECT_THAT(run.err, HasSubstr(about));
    };
    expect(runProgram({"breakage", "--device", "cpu"}), 2, "--out DIR");
    expect(runProgram({"breakage", "teapot", "--device", "cpu"}), 2, "breakage");
    expect(runProgram({"breakage", "--device", "cpu", "--packings", "1.5", "--count"}), 2, "whole number");
    expect(run("a", {"--index", "3"}), 2, "between 0 and 2");
    expect(run("a", {"--index", "0", "--packings", "1"}), 2, "other settings");
    expect(runProgram({"breakage", "gather", "--out", folder_.path() / "a"}), 3, "missing");
    expect(runProgram({"breakage", "gather", "--out", folder_.path() / "none"}), 3, "cannot be read");
    expect(runProgram({"breakage", "/no/such/file.toml", "--device", "cpu"}), 3, "/no/such/file.toml");
    const auto file = folder_.write("occupied", "");
    expect(runProgram({"breakage", experiment_, "--device", "cpu", "--out", file}), 6, "occupied");
}

}  // namespace
}  // namespace demolish::test
