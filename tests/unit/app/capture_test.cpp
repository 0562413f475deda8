// SPDX-License-Identifier: Apache-2.0
// A capture from start to end: pictures, contact sheet, film, report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "engine/image/unfinished_file.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

TEST(Capture, WritesWholeFilesAndAReport) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto out = folder.path() / "frames";
    const bool has_ffmpeg = std::system("ffmpeg -version > /dev/null 2>&1") == 0;
    std::vector<std::string> words = {"capture",  "block", "--particles", "200",
                                      "--frames", "14",    "--size",      "160x90",
                                      "--out",    out,     "--report",    folder.path() / "report.json"};
    if (has_ffmpeg) words.insert(words.end(), {"--video", folder.path() / "film.mp4"});
    const ProgramRun run = runProgram(words);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, testing::AllOf(testing::HasSubstr("FPS median"), testing::HasSubstr("fragments")));

    const auto first = engine::readPng(out / "frame_0000.png");
    const auto last = engine::readPng(out / "frame_0013.png");
    EXPECT_EQ(first.width, 160);
    EXPECT_EQ(first.height, 90);
    EXPECT_NE(first.pixels, last.pixels) << "nothing moved";
    const auto sheet = engine::readPng(out / "contact_sheet.png");
    EXPECT_GT(sheet.width, 3 * 160);
    for (const auto& entry : std::filesystem::directory_iterator(out))
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << "an unfinished file";
    if (has_ffmpeg) {
        EXPECT_GT(std::filesystem::file_size(folder.path() / "film.mp4"), 1000u);
    }

    const auto report = nlohmann::json::parse(readText(folder.path() / "report.json"));
    EXPECT_EQ(report["frames"], 14);
    EXPECT_EQ(report["width"], 160);
    EXPECT_NE(report["gl_renderer"], "none");
    EXPECT_GT(report["bonds_broken"].get<int>(), 0) << "25 m/s breaks the block";
    EXPECT_GT(report["fps_median"].get<double>(), 0);
    EXPECT_GE(report["frame_ms_p99"].get<double>(), report["sim_ms"].get<double>());
}

TEST(Capture, EachSceneThatIsShippedIsDrawn) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(DEMOLISH_SOURCE_DIR) / "assets/scenes"))
        for (const std::string quality : {"draft", "full"}) {
            const std::string scene = entry.path().stem();
            const ProgramRun run =
                runProgram({"capture", scene, "--particles", "8", "--frames", "1", "--size", "64x36",
                            "--quality", quality, "--out", folder.path() / "out"});
            EXPECT_EQ(run.exit_code, 0) << scene << ", " << quality << ": " << run.err;
        }
}

TEST(Capture, EachMethodIsCaptured) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    for (const std::string method : {"ours", "heavy", "cores", "pattern", "pattern-at-impact"}) {
        const auto out = folder.path() / method, report = folder.path() / (method + ".json");
        const ProgramRun run =
            runProgram({"capture", "block", "--particles", "100", "--pieces", "6", "--method", method,
                        "--frames", "40", "--size", "160x90", "--out", out, "--report", report});
        ASSERT_EQ(run.exit_code, 0) << method << run.err;
        EXPECT_NE(engine::readPng(out / "frame_0000.png").pixels,
                  engine::readPng(out / "frame_0039.png").pixels)
            << method;
        EXPECT_GT(nlohmann::json::parse(readText(report))["bonds_broken"].get<int>(), 0) << method;
    }
}

/// What two pictures show otherwise.
struct Change {
    size_t pixels = 0;
    double red = 0, blue = 0;  // sums over them, of the second picture
};

Change changeOf(const engine::Image& before, const engine::Image& after) {
    Change change;
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const uint8_t *a = before.at(x, y), *b = after.at(x, y);
            if (std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 40) continue;
            ++change.pixels;
            change.red += b[0];
            change.blue += b[2];
        }
    return change;
}

TEST(Capture, FreshFacesShowTheInnerMaterialAndTheOutsideStays) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    for (const std::string inner : {"plaster", "brick"}) {
        const ProgramRun run = runProgram({"capture",
                                           "block",
                                           "--particles",
                                           "200",
                                           "--material",
                                           "plaster",
                                           "--inner-material",
                                           inner,
                                           "--impact-velocity",
                                           "60",
                                           "--effects",
                                           "off",
                                           "--at",
                                           "0,0.3",
                                           "--size",
                                           "320x180",
                                           "--device",
                                           "cpu",
                                           "--out",
                                           folder.path() / inner});
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    const auto shown = [&](const std::string& inner, const std::string& frame) {
        return engine::readPng(folder.path() / inner / ("frame_" + frame + ".png"));
    };
    EXPECT_EQ(shown("plaster", "0000").pixels, shown("brick", "0000").pixels) << "whole, it is not seen";
    const Change change = changeOf(shown("plaster", "0001"), shown("brick", "0001"));
    EXPECT_GT(change.pixels, 300u) << "of 57,600";
    EXPECT_GT(change.red, 1.25 * change.blue) << "brick is red, plaster white";
}

TEST(Capture, InterruptedItKeepsWhatWasMade) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto out = folder.path() / "frames";
    const bool has_ffmpeg = std::system("ffmpeg -version > /dev/null 2>&1") == 0;
    std::vector<std::string> words = {"capture",  "block", "--particles", "100",
                                      "--frames", "90000", "--size",      "96x54",
                                      "--out",    out,     "--report",    folder.path() / "report.json"};
    if (has_ffmpeg) words.insert(words.end(), {"--video", folder.path() / "film.mp4"});
    const std::string third = (out / "frame_0002.png").string();
    const ProgramRun run = runProgram(words, {},
                                      {"bash", "-c",
                                       "\"$@\" & while kill -0 $! && ! [ -e '" + third +
                                           "' ]; do sleep 0.05; done; "
                                           "kill -TERM $!; wait $!",
                                       "bash"});
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("of 90000; what was made until then is whole"));
    EXPECT_TRUE(std::filesystem::exists(out / "contact_sheet.png"));
    const auto report = nlohmann::json::parse(readText(folder.path() / "report.json"));
    const auto frames = report["frames"].get<uint64_t>();
    EXPECT_GE(frames, 3u);
    char last[32];
    std::snprintf(last, sizeof last, "frame_%04u.png", static_cast<unsigned>(frames - 1));
    EXPECT_EQ(engine::readPng(out / last).width, 96);
    if (has_ffmpeg) {
        EXPECT_GT(std::filesystem::file_size(folder.path() / "film.mp4"), 500u);
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << "an unfinished file";
    }
}

TEST(Capture, InterruptedWithinALongFrameItKeepsTheFramesBefore) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto out = folder.path() / "frames";
    const std::string said = (folder.path() / "said.txt").string();
    // A frame of a second in 1,200,000 substeps takes minutes; who waits for its end is killed.
    const ProgramRun run = runProgram(
        {"capture", "block", "--device", "cpu", "--particles", "1000", "--fps", "1", "--substeps", "20000",
         "--frames", "3", "--size", "96x54", "--out", out, "--report", folder.path() / "report.json"},
        {},
        {"bash", "-c",
         "\"$@\" 2> '" + said + "' & p=$!; while kill -0 $p && ! grep -q 'breaking and drawing' '" + said +
             "'; do sleep 0.05; done; sleep 0.3; kill -TERM $p; "
             "for k in $(seq 300); do kill -0 $p || break; sleep 0.1; done; kill -KILL $p; wait $p",
         "bash"});
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_THAT(readText(said), testing::HasSubstr("after frame 1 of 3; what was made until then is whole"));
    const auto report = nlohmann::json::parse(readText(folder.path() / "report.json"));
    EXPECT_EQ(report["frames"], 1);
    EXPECT_EQ(report["bonds_broken"], 0);
    EXPECT_EQ(engine::readPng(out / "frame_0000.png").width, 96);
}

TEST(Capture, AFilmThatDoesNotFitOnTheDiskIsCodeSix) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
    const TemporaryFolder folder;
    const auto film = folder.path() / "film.mp4";
    // Files of 2 KiB at most, which a write is told of as of a full disk.
    const ProgramRun run = runProgram(
        {"capture", "block", "--particles", "100", "--frames", "14", "--size", "320x180", "--video", film},
        {}, {"bash", "-c", "trap '' XFSZ; ulimit -f 2; exec \"$@\"", "bash"});
    EXPECT_EQ(run.exit_code, 6) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("could not write the video"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing that looks like a film";
}

TEST(Capture, AFilmThatFailsIsCodeSixWhereChildrenAreIgnored) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.write("ffmpeg", "#!/bin/sh\ncat > /dev/null\nexit 1\n"),
                                 std::filesystem::perms::owner_all);
    const ProgramRun run = runProgram({"capture", "block", "--particles", "50", "--frames", "2", "--size",
                                       "96x54", "--video", folder.path() / "film.mp4"},
                                      {"PATH=" + folder.path().string() + ":" + std::getenv("PATH")},
                                      {"env", "--ignore-signal=CHLD"});
    EXPECT_EQ(run.exit_code, 6) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("could not write the video"));
}

TEST(Capture, FilmsMayHaveNamesThatLookLikeOptionsOrProtocols) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
    const TemporaryFolder folder;
    for (const char* name : {"take:1.mp4", "-x.mp4", "file:a.mp4", "50%d.mp4"}) {
        const ProgramRun run = runProgram({"capture", "block", "--particles", "50", "--frames", "2", "--size",
                                           "96x54", std::string("--video=") + name},
                                          {}, {"env", "--chdir", folder.path()});
        EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
    }
}

TEST(Capture, AFilmOfAnotherKindIsRefusedBeforeAnythingIsDrawn) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const ProgramRun run = runProgram({"capture", "block", "--particles", "50", "--frames", "2", "--size",
                                       "96x54", "--video", folder.path() / "film.gif"});
    EXPECT_EQ(run.exit_code, 6) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("ends with .mp4"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

/// It may outlive a program that is killed, and comes to its file after the next run has swept.
TEST(Capture, AFilmMakerThatOutlivesTheRunLeavesNothing) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto films = folder.path() / "films";
    const std::string started = folder.path() / "started", swept = folder.path() / "swept",
                      ended = folder.path() / "ended";
    std::filesystem::permissions(
        folder.write("ffmpeg",
                     "#!/bin/bash\ntouch " + started + "\nuntil [ -e " + swept +
                         " ]; do sleep 0.02; done\nfilm=\"${@: -1}\"\necho film > \"${film#file:}\"\ntouch " +
                         ended + "\n"),
        std::filesystem::perms::owner_all);
    runProgram(
        {"capture", "block", "--particles", "50", "--frames", "2", "--size", "96x54", "--video",
         films / "film.mp4"},
        {"PATH=" + folder.path().string() + ":" + std::getenv("PATH")},
        {"bash", "-c",
         "\"$@\" & p=$!; until [ -e " + started + " ]; do sleep 0.02; done; kill -KILL $p; wait $p", "bash"});
    engine::removeAbandonedFiles(films);
    folder.write("swept", "");
    for (int k = 0; k < 500 && !std::filesystem::exists(ended); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(std::filesystem::exists(ended)) << "the maker of the film never came to its end";
    EXPECT_TRUE(std::filesystem::is_empty(films));
}

TEST(Capture, ParticlesAreColouredByWhatTheViewNames) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    std::vector<std::vector<uint8_t>> pictures;
    for (const char* view : {"surface", "particles", "damage", "stress", "speed"}) {
        const auto out = folder.path() / view;
        const ProgramRun run =
            runProgram({"capture", "block", "--device", "cpu", "--particles", "200", "--at", "0.25", "--size",
                        "160x90", "--view", view, "--out", out, "--report", out / "report.json"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const auto picture = engine::readPng(out / "frame_0000.png");
        for (const auto& other : pictures) EXPECT_NE(picture.pixels, other) << view;
        pictures.push_back(picture.pixels);
        const auto report = nlohmann::json::parse(readText(out / "report.json"));
        EXPECT_GT(report["max_stress_ratio"].get<double>(), 0);
    }
}

TEST(Capture, TheCameraTurnsRoundTheBody) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto pictureAt = [&](const std::string& yaw, const std::string& pitch) {
        const auto out = folder.path() / (yaw + "_" + pitch);
        const ProgramRun run =
            runProgram({"capture", "bunny", "--device", "cpu", "--particles", "100", "--frames", "1",
                        "--size", "160x90", "--camera-yaw", yaw, "--camera-pitch", pitch, "--out", out});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return engine::readPng(out / "frame_0000.png");
    };
    const engine::Image front = pictureAt("0", "0");
    EXPECT_TRUE(engine::compare(front, pictureAt("360", "0")).passed);
    EXPECT_FALSE(engine::compare(front, pictureAt("180", "0")).passed);
    EXPECT_FALSE(engine::compare(front, pictureAt("0", "30")).passed);
    EXPECT_EQ(runProgram({"capture", "bunny", "--camera-yaw", "500", "--out", folder.path()}).exit_code, 2);
}

TEST(Capture, TheCameraFollowsItsPathAtTheShotsTime) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto pictureAt = [&](const std::string& name, const std::string& time, const std::string& camera) {
        const auto scene =
            folder.write(name + ".toml",
                         "version = 1\nmodel = \"models/block.obj\"\n[impact]\nkind = \"none\"\n"
                         "[camera]\n" +
                             camera);
        const auto out = folder.path() / name;
        const ProgramRun run = runProgram({"capture", scene, "--device", "cpu", "--particles", "50", "--fps",
                                           "20", "--at", time, "--size", "160x90", "--out", out});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return engine::readPng(out / "frame_0000.png");
    };
    const std::string moving =
        "eye_m = [2, 1, 3]\ntarget_m = [0, 0.5, 0]\npath = [{ at_s = 0.4, eye_m = [-2, 2, 3] }]\n";
    const auto standing = [](const std::string& eye) {
        return "eye_m = [" + eye + "]\ntarget_m = [0, 0.5, 0]\n";
    };
    const engine::Image start = pictureAt("start", "0", moving);
    EXPECT_TRUE(engine::compare(start, pictureAt("first", "0", standing("2, 1, 3"))).passed);
    const engine::Image half = pictureAt("half", "0.2", moving);
    EXPECT_FALSE(engine::compare(start, half).passed);
    EXPECT_TRUE(engine::compare(half, pictureAt("middle", "0.2", standing("0, 1.5, 3"))).passed);
    EXPECT_TRUE(
        engine::compare(pictureAt("end", "0.6", moving), pictureAt("last", "0.6", standing("-2, 2, 3")))
            .passed)
        << "it stays at its last key";
}

TEST(Capture, MomentsFromTwoCamerasMakeOneSheet) {
    if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    const TemporaryFolder folder;
    const auto capture = [&](const std::string& at) {
        return runProgram({"capture", "bunny", "--device", "cpu", "--particles", "100", "--size", "160x90",
                           "--fps", "20", "--at", at, "--camera-yaw", "0,180", "--out", folder.path()});
    };
    const ProgramRun run = capture("0,0.7");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    // Row by row: a camera a row, its moments in order.
    std::vector<engine::Image> pictures;
    for (const char* name : {"frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"})
        pictures.push_back(engine::readPng(folder.path() / name));
    EXPECT_FALSE(engine::compare(pictures[0], pictures[1]).passed) << "later";
    EXPECT_FALSE(engine::compare(pictures[0], pictures[2]).passed) << "from behind";
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "frame_0004.png"));
    const engine::Image sheet = engine::readPng(folder.path() / "contact_sheet.png");
    EXPECT_EQ(sheet.width, 2 * 160 + 3 * 4);
    EXPECT_EQ(sheet.height, 2 * 90 + 3 * 4);
    EXPECT_EQ(capture("0.7,0.2").exit_code, 2) << "not in order";
    EXPECT_THAT(run.err, testing::Not(testing::HasSubstr("earlier")));
    EXPECT_THAT(capture("0").err,
                testing::HasSubstr("frames of an earlier, longer capture, from frame_0002.png on"));
}

}  // namespace
}  // namespace demolish::test
