// SPDX-License-Identifier: Apache-2.0
// The command line as a user meets it: help, exit codes, one sentence for each failure, the report's keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Program : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    }
    /// A small body: quick to make, breaks like a large one.
    static std::vector<std::string> smallBench(std::vector<std::string> more) {
        std::vector<std::string> words = {"bench",    "block", "--particles", "150",      "--frames", "3",
                                          "--warmup", "0",     "--no-draw",   "--device", "cpu"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static void expectOneSentence(const ProgramRun& run, int code, const std::string& about) {
        EXPECT_EQ(run.exit_code, code) << run.err;
        EXPECT_THAT(run.err, AllOf(HasSubstr("demolish: "), HasSubstr(about)));
    }
    /// A scene of the block among assets in the folder: one a test.
    void writeScene(const std::string& name, const std::string& keys) const {
        namespace fs = std::filesystem;
        const fs::path assets = fs::path(DEMOLISH_SOURCE_DIR) / "assets", own = folder_.path() / "assets";
        fs::create_directories(own / "scenes");
        for (const char* folder : {"models", "materials", "strength"})
            fs::create_directory_symlink(assets / folder, own / folder);
        folder_.write("assets/scenes/" + name + ".toml",
                      "version = 1\nmodel = \"models/block.obj\"\n" + keys);
    }
    TemporaryFolder folder_;
};

TEST_F(Program, HelpReadsWell) {
    const ProgramRun run = runProgram({"--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("view"), HasSubstr("capture"), HasSubstr("bench"), HasSubstr("info"),
                               HasSubstr("Exit codes")));
    const ProgramRun capture = runProgram({"capture", "--help"});
    EXPECT_EQ(capture.exit_code, 0);
    EXPECT_THAT(capture.out,
                AllOf(HasSubstr("--impact-velocity"), HasSubstr("--particle-size"), HasSubstr("--video"),
                      HasSubstr("Frames to draw (default: 150)"), HasSubstr("  demolish capture wolf")));
    EXPECT_THAT(capture.out, Not(HasSubstr("demolish bench"))) << "examples of other commands";
    const ProgramRun version = runProgram({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("demolish [0-9.]+ \\(([0-9a-z.-]+|unknown)\\)\n"));
}

TEST_F(Program, InfoOfAShotSaysWhatItWillTake) {
    const ProgramRun quick = runProgram({"info", "block", "--particles", "100", "--device", "cpu"});
    ASSERT_EQ(quick.exit_code, 0) << quick.err;
    EXPECT_THAT(quick.out, AllOf(HasSubstr("1 body, 100 particles"), HasSubstr("substeps a frame"),
                                 HasSubstr("a frame       about"), Not(HasSubstr("GL renderer"))));
    const ProgramRun slow = runProgram(
        {"info", "block", "--particles", "2000", "--device", "cpu", "--fps", "1", "--substeps", "20000"});
    EXPECT_THAT(slow.out, AllOf(HasSubstr("1200000 substeps a frame"), HasSubstr("this shot is slow here"),
                                HasSubstr("fewer --substeps (now 20000 per 1/60 s")));
    const ProgramRun preset = runProgram({"info", "block", "--particles", "2000", "--device", "cpu", "--fps",
                                          "1", "--substeps", "20000", "--method", "pattern"});
    EXPECT_EQ(preset.exit_code, 0) << preset.err;
    EXPECT_THAT(preset.out, HasSubstr("method pattern steps no bonds"));
    EXPECT_THAT(preset.out, testing::Not(HasSubstr("substep")));
    expectOneSentence(runProgram({"info", "teapot"}), 2, "block, bunny");
}

TEST_F(Program, AnInterruptEndsTheMakingAtOnce) {
    // A stage of 400,000 cells takes longer than the five seconds after which who still runs is killed.
    const ProgramRun run = runProgram(
        {"bench", "block", "--particles", "400000", "--no-draw", "--device", "cpu", "--frames", "1"}, {},
        {"bash", "-c",
         "\"$@\" & p=$!; sleep 3; kill -TERM $p; for k in $(seq 50); do kill -0 $p || break; sleep 0.1; "
         "done; "
         "kill -KILL $p; wait $p",
         "bash"});
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("interrupted before the first frame; nothing was made"));
}

TEST_F(Program, ASlowShotIsSaidBeforeItRuns) {
    const ProgramRun run =
        runProgram({"bench", "block", "--particles", "2000", "--no-draw", "--device", "cpu", "--fps", "1",
                    "--substeps", "20000", "--frames", "1"},
                   {},
                   {"bash", "-c",
                    "\"$@\" & p=$!; (sleep 100; kill -KILL $p) & sleep 15; kill -TERM $p; wait $p", "bash"});
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_THAT(run.err, HasSubstr("this shot is slow here"));
}

TEST_F(Program, MistakesInUsageAreCodeTwo) {
    expectOneSentence(runProgram({}), 2, "give a command: view, capture");
    expectOneSentence(runProgram({"brake", "bunny"}), 2, "no command 'brake'; choose one of: view, capture");
    expectOneSentence(runProgram(smallBench({"--impact-velocity", "25km/h"})), 2,
                      "plain number, in SI units");
    expectOneSentence(runProgram({"bench", "block", "--no-draw", "--particles", "5000000"}), 2,
                      "5000000; it must be between 2 and 4000000");
    expectOneSentence(runProgram({"bench", "teapot", "--no-draw"}), 2, "block, bunny");
    expectOneSentence(runProgram({"bench", "--no-such-option"}), 2, "--no-such-option");
    expectOneSentence(runProgram(smallBench({"--impact-velocity", "-1"})), 2, "between 0 and 200 m/s");
    expectOneSentence(runProgram(smallBench({"--impact-velocity", "nan"})), 2, "between 0 and 200 m/s");
    expectOneSentence(runProgram({"bench", "--no-draw", "--particle-size", "0"}), 2, "--particle-size");
    expectOneSentence(runProgram(smallBench({"--particle-size", "0.1"})), 2, "exclude each other");
    expectOneSentence(runProgram(smallBench({"--drop", "3", "--impact-velocity", "3"})), 2,
                      "exclude each other");
    expectOneSentence(runProgram({"bench", "--no-draw", "--particles", "12.5"}), 2, "whole number");
    expectOneSentence(runProgram({"capture", "block", "--size", "12x", "--out", folder_.path()}), 2,
                      "1920x1080");
    expectOneSentence(runProgram({"capture", "block"}), 2, "--out");
    expectOneSentence(runProgram(smallBench({"--material", "jelly"})), 2, "ceramic");
    expectOneSentence(runProgram(smallBench({"--seed", "4294967296"})), 2, "between 0 and 4294967295");
    expectOneSentence(
        runProgram({"capture", "block", "--frames", "3", "--at", "0.1", "--out", folder_.path()}), 2,
        "excludes");
}

TEST_F(Program, EmptyValuesAreRefused) {
    for (const char* option : {"--impact-velocity", "--model", "--size", "--seed"})
        expectOneSentence(runProgram(smallBench({option, ""})), 2,
                          std::string(option) + ": is empty; give a value");
    expectOneSentence(runProgram({"bench", "", "--no-draw"}), 2, "scene: is empty");
}

TEST_F(Program, ParticleSizesThatCannotBeNameThoseThatCan) {
    expectOneSentence(runProgram({"bench", "block", "--no-draw", "--device", "cpu", "--particle-size", "9"}),
                      2, "out of range for the model 'block'; choose one from 0.");
}

TEST_F(Program, ASetBecomesASceneFileThatIsNeverWrittenOver) {
    const std::string set =
        test::writeGltfSet(folder_.path(), "set.gltf",
                           R"([{"name":"a","mesh":0},{"name":"b","mesh":0,"translation":[3,0,0]}])", "[0,1]")
            .string();
    const std::string file = (folder_.path() / "my_shot.toml").string();
    const std::filesystem::path left_by_killed = folder_.write(".demolish.1.0", "version");
    const ProgramRun written = runProgram({"scene", set, "--out", file});
    EXPECT_EQ(written.exit_code, 0) << written.err;
    EXPECT_FALSE(std::filesystem::exists(left_by_killed));
    EXPECT_THAT(written.out, HasSubstr("2 bodies, 0 colliders"));
    const ProgramRun run = runProgram({"bench", file, "--no-draw", "--device", "cpu", "--particles", "40",
                                       "--frames", "2", "--warmup", "0"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const std::string tall = (folder_.path() / "tall.toml").string();
    EXPECT_EQ(runProgram({"scene", set, "--height", "2.5", "--out", tall}).exit_code, 0);
    std::stringstream text;
    text << std::ifstream(tall).rdbuf();
    EXPECT_THAT(text.str(), HasSubstr("scale = 2.5\n"));
    expectOneSentence(runProgram({"scene", set, "--height", "500", "--out", file + "2.toml"}), 2, "--height");
    expectOneSentence(runProgram({"scene", set, "--out", file}), 6, "is there already");
    expectOneSentence(runProgram({"scene", set, "--out", "my_shot.txt"}), 2, "ends in .toml");
    expectOneSentence(runProgram({"bench", "block", "--no-draw", "--split"}), 2, "--split is for --model");
}

TEST_F(Program, BadInputFilesAreCodeThree) {
    expectOneSentence(runProgram({"bench", "--no-draw", "--model", "/no/such/file.obj"}), 3,
                      "/no/such/file.obj");
    const auto open_mesh = folder_.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectOneSentence(runProgram({"bench", "--no-draw", "--repair", "off", "--model", open_mesh}), 3,
                      "open.obj");
    expectOneSentence(runProgram({"bench", "--no-draw"}, {"DEMOLISH_DATA=/no/such/folder"}), 3,
                      "DEMOLISH_DATA");
}

TEST_F(Program, ABodyInsideAColliderIsCodeThree) {
    writeScene("inside",
               "collider = [{ shape = \"box\", size_m = [9, 0.1, 9], position_m = [0, 0.2, 0] }]\n");
    const auto data = "DEMOLISH_DATA=" + folder_.path().string();
    expectOneSentence(
        runProgram({"bench", "inside", "--no-draw", "--device", "cpu", "--particles", "50"}, {data}), 3,
        "Body 0 of the scene starts inside its collider 1, a box");
}

TEST_F(Program, NoGpuIsCodeFour) {
    if (runProgram({"info"}).out.find("CUDA device   none") == std::string::npos)
        GTEST_SKIP() << "there is a GPU";
    expectOneSentence(runProgram({"bench", "block", "--no-draw", "--device", "cuda"}), 4, "--device cpu");
}

TEST_F(Program, WindowWithoutDisplayIsCodeFour) {
    const ProgramRun run = runProgram({"view", "block", "--particles", "50", "--device", "cpu"},
                                      {"DISPLAY=", "WAYLAND_DISPLAY="});
    expectOneSentence(run, 4, "demolish capture");
}

TEST_F(Program, ABodyThatLeavesTheSceneIsCodeFive) {
    writeScene("narrow", "[solver]\nscene_radius_m = 0.2\n");
    const auto report = folder_.path() / "report.json";
    const ProgramRun run = runProgram({"bench", "narrow", "--no-draw", "--device", "cpu", "--particles",
                                       "100", "--frames", "2", "--json", report},
                                      {"DEMOLISH_DATA=" + folder_.path().string()});
    expectOneSentence(run, 5, "flew out of the scene");
    EXPECT_NE(nlohmann::json::parse(readText(report)).value("status", ""), "ok")
        << "the report is written all the same";
}

TEST_F(Program, OutputThatCannotBeWrittenIsCodeSix) {
    const ProgramRun bench = runProgram(smallBench({"--json", "/no/such/folder/report.json"}));
    expectOneSentence(bench, 6, "/no/such/folder/report.json");
    EXPECT_EQ(bench.err.find("cells and bonds"), std::string::npos) << "said before the work, not after it";
    folder_.write("plain", "a file");
    expectOneSentence(runProgram({"capture", "block", "--particles", "50", "--frames", "1", "--out",
                                  folder_.path() / "plain"}),
                      6, "plain");
    const ProgramRun no_ffmpeg = runProgram(
        {"capture", "block", "--particles", "50", "--frames", "1", "--video", folder_.path() / "film.mp4"},
        {"PATH=/no/such/folder"});
    expectOneSentence(no_ffmpeg, 6, "ffmpeg program is missing");
}

TEST_F(Program, ReportHasTheKeysInSiUnits) {
    const auto file = folder_.path() / "report.json";
    const ProgramRun run = runProgram(smallBench({"--json", file}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto report = nlohmann::json::parse(readText(file));
    for (const char* key : {"scene",
                            "model",
                            "device",
                            "gl_renderer",
                            "transfer",
                            "seed",
                            "frames",
                            "fps_median",
                            "fps_p1",
                            "frame_ms_p99",
                            "sim_ms",
                            "draw_ms",
                            "substeps_per_frame",
                            "time_step",
                            "particles",
                            "bonds",
                            "bonds_broken",
                            "fragments",
                            "largest_fragment_fraction",
                            "mass",
                            "mesh_volume",
                            "cells_volume",
                            "linear_momentum",
                            "energy",
                            "state_hash",
                            "status",
                            "machine",
                            "threads",
                            "softening"})
        EXPECT_TRUE(report.contains(key)) << key;
    for (const char* key : {"kinetic", "elastic", "potential", "damping", "friction", "fracture", "external"})
        EXPECT_TRUE(report["energy"].contains(key)) << key;
    EXPECT_EQ(report["scene"], "block");
    EXPECT_EQ(report["particles"], 150);
    EXPECT_EQ(report["frames"], 3);
    EXPECT_EQ(report["status"], "ok");
    EXPECT_NEAR(report["mesh_volume"].get<double>(), 1.0, 1e-12);
    EXPECT_NEAR(report["cells_volume"].get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(report["mass"].get<double>(), 2650, 1e-3);
    EXPECT_GT(report["sim_ms"].get<double>(), 0);
    EXPECT_NEAR(report["time_step"].get<double>() * report["substeps_per_frame"].get<double>(), 1.0 / 60,
                1e-6);
}

TEST_F(Program, TheSameSeedGivesTheSameHashAndAnotherSeedAnother) {
    const auto hashOf = [&](const std::string& seed) {
        const auto file = folder_.path() / "report.json";
        const ProgramRun run = runProgram(smallBench({"--seed", seed, "--json", file}));
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return nlohmann::json::parse(readText(file)).value("state_hash", "");
    };
    const std::string first = hashOf("1");
    EXPECT_EQ(hashOf("1"), first);
    EXPECT_NE(hashOf("2"), first);
}

}  // namespace
}  // namespace demolish::test
