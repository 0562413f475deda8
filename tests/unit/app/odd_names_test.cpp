// SPDX-License-Identifier: Apache-2.0
// Models whose names are no text: the run and its report go through, and what is said stays one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OddNames : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    }
    fs::path cubeAs(const std::string& name) {
        const fs::path file = folder_.path() / name;
        fs::copy_file(fs::path(DEMOLISH_SOURCE_DIR) / "assets" / "models" / "block.obj", file);
        return file;
    }
    static std::vector<std::string> benchOf(const std::string& model, std::vector<std::string> more) {
        std::vector<std::string> words = {"bench",    "--particles", "60",      "--frames",
                                          "2",        "--warmup",    "0",       "--no-draw",
                                          "--device", "cpu",         "--model", model};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    TemporaryFolder folder_;
};

TEST_F(OddNames, TheReportOfAModelWhoseNameIsNoUtf8) {
    const fs::path report = folder_.path() / "report.json", csv = folder_.path() / "report.csv";
    const ProgramRun run = runProgram(benchOf(cubeAs("caf\xe9\xff.obj"), {"--json", report, "--csv", csv}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("caf??.obj"));
    EXPECT_EQ(nlohmann::json::parse(readText(report))["model"], "caf\uFFFD\uFFFD.obj");
    EXPECT_THAT(readText(csv), HasSubstr("caf??.obj"));
}

TEST_F(OddNames, ARefusalIsOneLineWhateverTheNameHolds) {
    for (const char* name : {"two\nlines.obj", "bell\a.obj", "\xf0\x28.obj"}) {
        const ProgramRun run = runProgram(benchOf(folder_.write(name, "v 0 0 0\n"), {}));
        EXPECT_EQ(run.exit_code, 3) << run.err;
        const std::string sentence = run.err.substr(run.err.find("demolish: "));
        EXPECT_EQ(std::count_if(sentence.begin(), sentence.end(), [](unsigned char c) { return c < 0x20; }),
                  1)
            << sentence;
        EXPECT_NO_THROW(static_cast<void>(nlohmann::json(sentence).dump())) << "no UTF-8";
    }
}

TEST_F(OddNames, AReportThatCannotBeWrittenCostsNoOtherOutput) {
    // Files of 2 KiB at most, which a write is told of as of a full disk: the JSON has more.
    const fs::path json = folder_.path() / "report.json", csv = folder_.path() / "report.csv";
    const ProgramRun run = runProgram(
        benchOf(cubeAs("cube.obj"), {"--json", json, "--csv", csv}), {},
        {"bash", "-c", "trap '' XFSZ; (ulimit -f 2; exec \"$@\") | cat; exit ${PIPESTATUS[0]}", "bash"});
    EXPECT_EQ(run.exit_code, 6) << run.err;
    EXPECT_THAT(run.err, HasSubstr("report.json"));
    EXPECT_THAT(run.out, HasSubstr("state hash"));
    EXPECT_FALSE(fs::exists(json));
    EXPECT_FALSE(readText(csv).empty());
}

}  // namespace
}  // namespace demolish::test
