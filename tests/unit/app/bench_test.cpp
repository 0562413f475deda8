// SPDX-License-Identifier: Apache-2.0
// demolish bench as a user meets it: phases of a scene, the three ways to time it, files beside the table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

using testing::HasSubstr;

/// A data folder with one scene of its own: a small block that is hit at once, in two phases of 3 and 9
/// frames.
class Bench : public testing::Test {
  protected:
    void SetUp() override {
        namespace fs = std::filesystem;
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
        const fs::path source = DEMOLISH_SOURCE_DIR, own = folder_.path() / "assets";
        fs::create_directories(own / "scenes");
        fs::create_directory_symlink(source / "assets/models", own / "models");
        fs::create_directory_symlink(source / "assets/materials", own / "materials");
        fs::create_directory_symlink(source / "assets/strength", own / "strength");
        fs::create_directory_symlink(source / "shaders", folder_.path() / "shaders");
        folder_.write("assets/scenes/phased.toml",
                      "version = 1\nmodel = \"models/block.obj\"\nmaterial_preset = \"stone\"\n"
                      "[particles]\nfull = 150\ndraft = 150\n"
                      "[impact]\nkind = \"ball\"\nvelocity_mps = 120\narrival_s = 0.06\n"
                      "[[phase]]\nname = \"whole\"\nfrom_s = 0\nto_s = 0.05\npaper_fps = 280\n"
                      "[[phase]]\nname = \"all broken\"\nfrom_s = 0.05\nto_s = 0.2\npaper_fps = 155\n");
    }

    ProgramRun bench(std::vector<std::string> more) {
        std::vector<std::string> words = {"bench", "phased", "--device", "cpu",    "--warmup",
                                          "2",     "--size", "160x90",   "--json", report()};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words, {"DEMOLISH_DATA=" + folder_.path().string()});
    }
    std::string report() const { return folder_.path() / "report.json"; }
    nlohmann::json read() const { return nlohmann::json::parse(readText(report())); }

    TemporaryFolder folder_;
};

std::vector<std::string> split(const std::string& line) {
    std::istringstream fields(line);
    std::vector<std::string> all;
    for (std::string field; std::getline(fields, field, ',');) all.push_back(field);
    return all;
}

/// All bonds that broke, frame by frame, in a file with a line for each of so many frames.
int brokenIn(const std::string& frame_csv, int frames) {
    std::istringstream lines(frame_csv);
    std::string line;
    std::getline(lines, line);
    const auto names = split(line);
    const auto column = std::find(names.begin(), names.end(), "bonds_broken_now") - names.begin();
    int broken = 0, count = 0;
    for (; std::getline(lines, line); ++count) {
        EXPECT_EQ(split(line).size(), names.size());
        broken += std::stoi(split(line).at(column));
    }
    EXPECT_EQ(count, frames);
    return broken;
}

TEST_F(Bench, RunsThePhasesOfTheSceneBesideThePapersRates) {
    const auto csv = folder_.path() / "rows.csv", frames = folder_.path() / "frames.csv",
               curve = folder_.path() / "curve.svg";
    const ProgramRun run = bench({"--no-draw", "--csv", csv, "--frame-csv", frames, "--curve", curve});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = read();
    EXPECT_EQ(json["frames"], 12) << "to the end of the last phase";
    EXPECT_NEAR(json["frame_seconds"].get<double>(), 1.0 / 60, 1e-6) << "no frame simulates less";
    const auto& rows = json["phases"];
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0]["phase"], "whole");
    EXPECT_EQ(rows[0]["frames"], 3);
    EXPECT_EQ(rows[0]["paper_fps"], 280);
    EXPECT_EQ(rows[0]["fragments"], 1);
    EXPECT_NEAR(rows[0]["ratio"].get<double>(), rows[0]["fps_median"].get<double>() / 280, 1e-9);
    EXPECT_EQ(rows[1]["phase"], "all broken");
    EXPECT_EQ(rows[1]["frames"], 9);
    EXPECT_GT(rows[1]["fragments"].get<int>(), 1);
    EXPECT_EQ(rows[2]["phase"], "while it breaks");
    EXPECT_GE(rows[2]["frames"].get<int>(), rows[3]["frames"].get<int>());
    EXPECT_EQ(rows[3]["phase"], "breaking");
    EXPECT_GT(rows[3]["frames"].get<int>(), 0);
    EXPECT_LT(rows[3]["frames"].get<int>(), 12);
    EXPECT_EQ(rows[4]["frames"], 12);
    EXPECT_EQ(rows[4]["particles"], 150);
    EXPECT_GT(rows[4]["sim_ms"].get<double>(), 0);
    EXPECT_EQ(rows[4]["draw_ms"], 0);
    EXPECT_THAT(run.out,
                testing::AllOf(HasSubstr("all broken"), HasSubstr("breaking"), HasSubstr("paper's")));
    const std::string lines = readText(csv);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 6);
    EXPECT_EQ(brokenIn(readText(frames), 12), json["bonds_broken"]);
    EXPECT_THAT(readText(curve), testing::AllOf(HasSubstr("<svg"), HasSubstr(">all broken<")));
}

TEST_F(Bench, FramesMayBeChosenAndAPhaseThatIsNotReachedSaysSo) {
    ASSERT_EQ(bench({"--no-draw", "--frames", "3"}).exit_code, 0);
    const auto json = read();
    EXPECT_EQ(json["frames"], 3);
    EXPECT_EQ(json["phases"][1]["frames"], 0);
    EXPECT_TRUE(json["phases"][1]["fps_median"].is_null());
}

TEST_F(Bench, FramesMayBeKeptAsInTheWindow) {
    ASSERT_EQ(bench({}).exit_code, 0);
    const auto hash = read()["state_hash"];
    const ProgramRun run = bench({"--record"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(read()["state_hash"], hash);
    EXPECT_EQ(bench({"--record", "--no-draw"}).exit_code, 2);
}

TEST_F(Bench, DrawingARecordingTimesTheSameFramesWithoutTheSolver) {
    ASSERT_EQ(bench({"--no-draw"}).exit_code, 0);
    const auto simulated = read();
    const ProgramRun run = bench({"--draw-only"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto drawn = read();
    EXPECT_EQ(drawn["mode"], "draw only");
    EXPECT_EQ(drawn["state_hash"], simulated["state_hash"]);
    ASSERT_EQ(drawn["phases"].size(), simulated["phases"].size());
    for (size_t i = 0; i < 4; ++i) {
        const auto &a = drawn["phases"][i], &b = simulated["phases"][i];
        EXPECT_EQ(a["frames"], b["frames"]);
        EXPECT_EQ(a["fragments"], b["fragments"]);
        EXPECT_EQ(a["sim_ms"], 0);
        EXPECT_GT(a["draw_ms"].get<double>(), 0);
        EXPECT_EQ(b["draw_ms"], 0);
        EXPECT_EQ(b["triangles"], 0);
    }
    EXPECT_GE(drawn["phases"][0]["triangles"].get<int>(), 12);
    EXPECT_GT(drawn["phases"][1]["triangles"].get<int>(), drawn["phases"][0]["triangles"].get<int>())
        << "broken faces are drawn";
}

TEST_F(Bench, StepTransferAndDrawAreInTheFrame) {
    const ProgramRun run = bench({});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = read();
    EXPECT_EQ(json["width"], 160);
    EXPECT_EQ(json["transfer"], "host");
    const auto& all = json["phases"].back();
    for (const char* stage : {"sim_ms", "transfer_ms", "draw_ms"}) {
        EXPECT_GT(all[stage].get<double>(), 0) << stage;
        EXPECT_LT(all[stage].get<double>(), all["frame_ms_worst"].get<double>()) << stage;
    }
    EXPECT_GE(all["frame_ms_worst"].get<double>(), all["frame_ms_p99"].get<double>());
    EXPECT_GE(all["frame_ms_p99"].get<double>(), all["frame_ms_median"].get<double>());
}

TEST_F(Bench, AllMethodsOfThePapersComparisonStandInOneTable) {
    const ProgramRun run = bench({"--methods", "--pieces", "6"});
    ASSERT_EQ(run.exit_code, 0) << run.out;
    const auto rows = read()["methods"];
    ASSERT_EQ(rows.size(), 5u);
    std::map<std::string, nlohmann::json> by_name;
    for (const auto& row : rows) {
        by_name[row["name"]] = row;
        EXPECT_THAT(run.out, HasSubstr(row["name"].get<std::string>()));
        EXPECT_GT(row["fps_whole"].get<double>(), 0);
        EXPECT_GT(row["pieces"].get<int>(), 1) << row["name"];
        EXPECT_NEAR(row["energy_closure"].get<double>(), 1, 0.05) << row["name"];
    }
    EXPECT_EQ(by_name["pattern"]["map_distance"], 0) << "the same pieces wherever it is hit";
    EXPECT_GT(by_name["pattern-at-impact"]["map_distance"], 0.05);
    EXPECT_EQ(by_name["pattern-at-impact"]["paper_fps"], 130);
    EXPECT_TRUE(by_name["cores"]["paper_fps"].is_null());
    EXPECT_EQ(by_name["cores"]["pieces"], by_name["ours"]["pieces"]);
}

TEST_F(Bench, AComparisonTakesNoMethodAndOneFile) {
    EXPECT_EQ(bench({"--methods", "--method", "heavy"}).exit_code, 2);
    EXPECT_EQ(bench({"--methods", "--csv", folder_.path() / "rows.csv"}).exit_code, 2);
    EXPECT_EQ(bench({"--method", "magic"}).exit_code, 2);
    for (const char* list : {"--methods=magic", "--methods=ours,,heavy", "--methods=,"}) {
        const ProgramRun run = bench({list});
        EXPECT_EQ(run.exit_code, 2) << list;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

TEST_F(Bench, SomeMethodsAreCompared) {
    const ProgramRun run = bench({"--methods=ours,pattern", "--no-draw"});
    ASSERT_EQ(run.exit_code, 0) << run.out;
    const auto rows = read()["methods"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["name"], "pattern") << "in the paper's order";
    EXPECT_EQ(rows[1]["name"], "ours");
    EXPECT_NE(rows[0]["state_hash"], rows[1]["state_hash"]);
}

TEST_F(Bench, TheSubstepAloneIsTimedBesideTheMachinesFloor) {
    const auto csv = folder_.path() / "kernel.csv";
    const ProgramRun run = runProgram(
        {"bench", "--kernel", "--device", "cpu", "--particles", "216", "--json", report(), "--csv", csv});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = read();
    EXPECT_EQ(json["device"], "CPU");
    ASSERT_EQ(json["rows"].size(), 1u);
    const auto& row = json["rows"][0];
    EXPECT_EQ(row["particles"], 216);
    EXPECT_EQ(row["bonds"], 3 * 180 + 3 * 150);
    EXPECT_GT(row["shattering_broken"].get<int>(), 0);
    EXPECT_LT(row["shattering_broken"].get<int>(), row["bonds"].get<int>());
    EXPECT_EQ(row["broken_broken"], row["bonds"]);
    for (const char* time : {"intact_us", "shattering_us", "broken_us", "floor_memory_us"})
        EXPECT_GT(row[time].get<double>(), 0) << time;
    EXPECT_TRUE(row["floor_bonds_us"].is_null()) << "only a GPU has one";
    const std::string lines = readText(csv);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2);
}

TEST_F(Bench, TheSubstepAloneTakesNoScene) {
    for (const auto& words : std::vector<std::vector<std::string>>{{"bench", "bunny", "--kernel"},
                                                                   {"bench", "--kernel", "--draw-only"},
                                                                   {"bench", "--kernel", "--frames", "3"}}) {
        const ProgramRun run = runProgram(words);
        EXPECT_EQ(run.exit_code, 2);
        EXPECT_THAT(run.err, HasSubstr("--kernel times"));
    }
    EXPECT_EQ(runProgram({"bench", "--kernel", "--particles", "3", "--device", "cpu"}).exit_code, 2);
}

TEST_F(Bench, WaysThatExcludeEachOtherAreRefused) {
    const ProgramRun run = bench({"--no-draw", "--draw-only"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("exclude each other"));
}

}  // namespace
}  // namespace demolish::test
