// SPDX-License-Identifier: Apache-2.0
// demolish calibrate as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

using testing::HasSubstr;

class CalibrateProgram : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    }
    ProgramRun run(const std::vector<std::string>& more) {
        std::vector<std::string> words = {"calibrate", "block", "--particles", "150", "--device", "cpu"};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words, {"XDG_CACHE_HOME=" + (folder_.path() / "cache").string()});
    }
    TemporaryFolder folder_;
};

TEST_F(CalibrateProgram, PrintsAndKeepsTheThreshold) {
    const std::string report = folder_.path() / "threshold.json";
    const ProgramRun first = run({"--drop", "5", "--packings", "2", "--json", report});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("threshold"));
    const auto json = nlohmann::json::parse(readText(report));
    EXPECT_EQ(json["impact"], "drop");
    EXPECT_EQ(json["packings"], 2);
    EXPECT_GT(json["threshold"].get<double>(), json["bracket"][0].get<double>());
    EXPECT_LT(json["threshold"].get<double>(), json["bracket"][1].get<double>());
    EXPECT_NEAR(json["ratio"].get<double>() * json["predicted"].get<double>(), json["threshold"], 1e-6);
    EXPECT_THAT(run({"--drop", "5", "--packings", "2"}).out, HasSubstr("from the cache"));
    // Every report finds the measurement again.
    const std::string bench = folder_.path() / "bench.json";
    const ProgramRun timed =
        runProgram({"bench", "block", "--particles", "150", "--device", "cpu", "--drop", "5", "--mesh",
                    "fine", "--no-draw", "--frames", "2", "--warmup", "0", "--json", bench},
                   {"XDG_CACHE_HOME=" + (folder_.path() / "cache").string()});
    EXPECT_EQ(timed.exit_code, 0) << timed.err;
    const auto threshold = nlohmann::json::parse(readText(bench))["threshold"];
    EXPECT_NEAR(threshold["measured"].get<double>(), json["threshold"], 1e-9);
    EXPECT_EQ(threshold["source"], "measured on 2 packings");
}

TEST_F(CalibrateProgram, MistakesAreOneSentence) {
    const auto refused = [&](const std::vector<std::string>& words, const char* about) {
        const ProgramRun answer = run(words);
        EXPECT_EQ(answer.exit_code, 2) << answer.err;
        EXPECT_THAT(answer.err, HasSubstr(about));
    };
    refused({"--packings", "1.5"}, "--packings");
    refused({"--packings", "0"}, "--packings");
    refused({"--tolerance", "0"}, "--tolerance");
    refused({"--break-at", "1e9"}, "--break-at");
    refused({"--break-at", "nan"}, "--break-at");
}

}  // namespace
}  // namespace demolish::test
