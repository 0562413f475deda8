// `demolish breakage` as a user meets it: interrupted and resumed, by single items, by several processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

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
    ProgramRun run(const std::string& out, std::vector<std::string> more = {}) {
        std::vector<std::string> words{"breakage", experiment_, "--device",
                                       "cpu",      "--full",    "--batch",
                                       "3",        "--out",     folder_.path() / out};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
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
    const auto untouched = fs::last_write_time(items / "item_00000.json");
    ASSERT_EQ(run("resumed").exit_code, 0);
    EXPECT_EQ(fs::last_write_time(items / "item_00000.json"), untouched) << "computed again";
    expectSame("whole", "resumed");

    for (const char* index : {"2", "0", "1", "1"}) {
        const ProgramRun item = run("array", {"--index", index});
        EXPECT_EQ(item.exit_code, 0) << item.err;
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "array" / "specimens.csv"));
    const ProgramRun gathered = runProgram({"breakage", "gather", "--out", folder_.path() / "array"});
    EXPECT_EQ(gathered.exit_code, 0) << gathered.err;
    EXPECT_THAT(whole.out, HasSubstr(gathered.out));
    expectSame("whole", "array");

    const ProgramRun jobs = run("jobs", {"--jobs", "2"});
    EXPECT_EQ(jobs.exit_code, 0) << jobs.err;
    expectSame("whole", "jobs");
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
