// SPDX-License-Identifier: Apache-2.0
// demolish check: what is said of good, open and hopeless files, and by which exit code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A unit cube of quads, of which the first `faces` are there.
std::string boxText(int faces) {
    static const char* const kFaces[] = {"f 4 3 2 1\n", "f 5 6 7 8\n", "f 2 6 5 1\n",
                                         "f 3 7 6 2\n", "f 4 8 7 3\n", "f 1 5 8 4\n"};
    std::string text = "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 1 1 0\n";
    for (int face = 0; face < faces; ++face) text += kFaces[face];
    return text;
}

class Check : public testing::Test {
  protected:
    void SetUp() override {
        if (programPath().empty()) GTEST_SKIP() << "the program is not built here; set DEMOLISH_PROGRAM";
    }
    ProgramRun check(const std::string& text, std::vector<std::string> more = {}) {
        std::vector<std::string> words = {"check", folder_.write("model.obj", text).string(), "--particles",
                                          "60"};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    }
    TemporaryFolder folder_;
};

TEST_F(Check, AClosedModelIsTakenAsItIs) {
    const ProgramRun run = check(boxText(6));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("12 triangles, 1 part, 0 open edges"), HasSubstr("taken as it is"),
                               HasSubstr("yes: 60 cells, all closed")));
}

TEST_F(Check, AnOpenOneIsClosedOrRefusedAsAsked) {
    const ProgramRun closed = check(boxText(5));
    EXPECT_EQ(closed.exit_code, 0) << closed.err;
    EXPECT_THAT(closed.out,
                AllOf(HasSubstr("4 open edges"), HasSubstr("1 hole filled"), HasSubstr("yes: 60 cells")));
    const ProgramRun refused = check(boxText(5), {"--repair", "off"});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_THAT(refused.out, HasSubstr("no: "));
    EXPECT_THAT(refused.err, HasSubstr("is not closed: 4 open edges"));
}

TEST_F(Check, ASheetGetsTheThicknessAskedFor) {
    const ProgramRun run = check(boxText(1), {"--thickness", "0.125"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("1 sheet made 0.125 m thick"), HasSubstr("0.125 m^3")));
    EXPECT_EQ(check(boxText(1), {"--thickness", "-1"}).exit_code, 2);
    EXPECT_EQ(check(boxText(1), {"--repair", "never"}).exit_code, 2);
}

TEST_F(Check, AUnitKeepsTheSizeOfAFileThatSaysNone) {
    const ProgramRun unknown = check(boxText(6));
    EXPECT_THAT(unknown.out, AllOf(HasSubstr("1 x 1 x 1; model.obj does not say its unit"),
                                   HasSubstr("scaled to 1 m; --unit m, cm, mm, in or ft keeps"),
                                   HasSubstr("1 x 1 x 1 m")));
    const ProgramRun feet = check(boxText(6), {"--unit", "ft"});
    EXPECT_EQ(feet.exit_code, 0) << feet.err;
    EXPECT_THAT(feet.out, AllOf(HasSubstr("in units of 0.3048 m\n"), HasSubstr("0.305 x 0.305 x 0.305 m")));
    const ProgramRun tiny = check(boxText(6), {"--unit", "mm"});
    EXPECT_EQ(tiny.exit_code, 0) << tiny.err;
    EXPECT_THAT(tiny.out, AllOf(HasSubstr("model.obj is 0.001 m long, which is hardly meant"),
                                HasSubstr("yes: 60 cells")));
    EXPECT_EQ(check(boxText(6), {"--unit", "km"}).exit_code, 2);
    const ProgramRun both = check(boxText(6), {"--unit", "cm", "--height", "2"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_THAT(both.err, HasSubstr("--height and --unit exclude each other"));
}

/// As maps are, in metres from the equator: numbers of files are read in single precision.
TEST_F(Check, WhatLiesSoFarAwayThatItComesOutSteppedIsSaid) {
    std::string far = boxText(6);
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"v 0", "v 4649776"},
                                   std::pair<std::string, std::string>{"v 1", "v 4649777"}})
        for (size_t at = 0; (at = far.find(from, at)) != std::string::npos; at += to.size())
            far.replace(at, from.size(), to);
    const ProgramRun run = check(far);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("told to 0.5 only, and it comes out stepped: move it to the origin"));
    EXPECT_THAT(check(boxText(6)).out, testing::Not(HasSubstr("stepped")));
}

TEST_F(Check, AFormatInMetresKeepsItsSizeAndTakesNoUnit) {
    const std::string file = writeGltfSet(folder_.path(), "set.gltf",
                                          R"([{"name":"crate","mesh":0,"scale":[0.5,0.25,0.5]}])", "[0]")
                                 .string();
    const ProgramRun run = runProgram({"check", file, "--particles", "60"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("size          0.5 x 0.25 x 0.5 m\n"),
                               HasSubstr("0.0625 m^3, 0.5 x 0.25 x 0.5 m")));
    const ProgramRun higher = runProgram({"check", file, "--particles", "60", "--height", "1"});
    EXPECT_THAT(higher.out, HasSubstr("4 m^3, 2 x 1 x 2 m"));
    const ProgramRun refused = runProgram({"check", file, "--unit", "cm"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, HasSubstr("the format of 'set.gltf' says its unit itself"));
}

TEST_F(Check, TheSameAsJson) {
    const std::string file = (folder_.path() / "check.json").string();
    EXPECT_EQ(check(boxText(5), {"--json", file}).exit_code, 0);
    const auto json = nlohmann::json::parse(std::ifstream(file));
    EXPECT_EQ(json["open_edges"], 4);
    EXPECT_EQ(json["breaks"], true);
    EXPECT_EQ(json["repair"].size(), 1u);
    EXPECT_NEAR(json["volume_m3"].get<double>(), 1, 1e-9);
    EXPECT_NEAR(json["thin_wall_m"].get<double>(), 1, 1e-3);

    EXPECT_EQ(check("v 0 0 0\n", {"--json", file}).exit_code, 3);
    EXPECT_EQ(nlohmann::json::parse(std::ifstream(file))["breaks"], false);
}

}  // namespace
}  // namespace demolish::test
