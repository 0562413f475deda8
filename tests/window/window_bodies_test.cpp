// SPDX-License-Identifier: Apache-2.0
// A set in the window: bodies chosen, hidden, dragged, of another material; the report of an import and its
// choices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/window/window_program.h"

namespace demolish::test {
namespace {

using testing::HasSubstr;

/// Two blocks side by side before a camera that looks at their middle.
class WindowBodies : public WindowProgram {
  protected:
    void SetUp() override {
        WindowProgram::SetUp();
        scene_ = folder_
                     .write("two.toml",
                            "version = 1\nmodel = \"models/block.obj\"\nheight_m = 0.5\n"
                            "body = [ { name = \"left\", position_m = [-0.6, 0, 0] }, "
                            "{ name = \"right\", position_m = [0.6, 0, 0] } ]\n"
                            "[camera]\neye_m = [0, 0.8, 2.6]\ntarget_m = [0, 0.25, 0]\n")
                     .string();
    }
};

TEST_F(WindowBodies, HaveEyeLockMaterialAndAPlaceToBeDraggedTo) {
    run(R"(
wait 2
key space
key r
screenshot 20_two
state start
click bodies.eye.0
until rebuilt
wait 2
screenshot 21_left_hidden
state hidden
click bodies.eye.0
until rebuilt
wait 2
click bodies.name.1
click bodies.material
click bodies.material.concrete
until rebuilt
wait 2
state material
click bodies.arrange
click_picture 0.7 0.52
wait 2
screenshot 22_chosen
move_picture 0.7 0.56 0.8 0.66
until rebuilt
wait 2
screenshot 23_moved
state moved
click bodies.lock.1
until rebuilt
wait 2
move_picture 0.8 0.64 0.6 0.64
until rebuilt
wait 2
state locked
)",
        {}, 200);
    if (HasFatalFailure()) return;
    const auto start = read("start"), hidden = read("hidden"), material = read("material"),
               moved = read("moved"), locked = read("locked");
    EXPECT_EQ(start["bodies"][0]["name"], "left");
    EXPECT_EQ(hidden["bodies"][0]["hidden"], true);
    EXPECT_EQ(hidden["particles"], start["particles"]) << "it is there all the same";
    EXPECT_EQ(material["bodies"][0]["hidden"], false);
    EXPECT_EQ(material["bodies"][1]["material"], "concrete");
    EXPECT_NE(material["bodies"][0]["material"], "concrete");
    const auto place = [](const nlohmann::json& state) {
        return state["bodies"][1]["position_m"].get<std::vector<double>>();
    };
    EXPECT_GT(place(moved)[0], 0.62) << "to the right, as the mouse went";
    EXPECT_GT(place(moved)[2], 0.3) << "and nearer";
    EXPECT_NEAR(place(moved)[1], 0, 1e-3) << "on the floor";
    EXPECT_EQ(place(locked), place(moved));
    EXPECT_EQ(moved["bonds_broken"], 0) << "a click chooses, and shoots nothing";
    const auto two = engine::readPng(screenshot("20_two")),
               one = engine::readPng(screenshot("21_left_hidden"));
    EXPECT_LT(engine::compare(two, one).ssim, 0.99);
}

TEST_F(WindowProgram, AnImportIsReportedAndItsRepairAndUnitAreChosen) {
    const std::string open_box =
        "v 0 0 0\nv 0 0 40\nv 40 0 40\nv 40 0 0\nv 0 40 0\nv 0 40 40\nv 40 40 40\nv 40 40 0\n"
        "f 4 3 2 1\nf 2 6 5 1\nf 3 7 6 2\nf 4 8 7 3\nf 1 5 8 4\n";
    const std::string file = folder_.write("box.obj", open_box).string();
    run("wait 2\nkey space\ntype shot.model " + file + R"(
wait 3
until rebuilt
wait 3
state loaded
screenshot 25_report
click import.unit
click import.unit.cm
wait 3
until rebuilt
wait 2
state unit
click import.repair
click import.repair.off
wait 3
until rebuilt
wait 2
screenshot 26_refused
state refused
click import.repair
click import.repair.remesh
wait 3
until rebuilt
wait 2
screenshot 27_remeshed
state remeshed
)",
        {}, 200);
    if (HasFatalFailure()) return;
    EXPECT_NEAR(read("loaded")["body_size"].get<double>(), 1, 1e-6);
    EXPECT_NEAR(read("unit")["body_size"].get<double>(), 0.4, 1e-6);
    EXPECT_THAT(read("refused")["message"].get<std::string>(), HasSubstr("is not closed"));
    EXPECT_EQ(read("refused")["repair"], "auto") << "what cannot be made is not kept";
    EXPECT_EQ(read("remeshed")["repair"], "remesh");
    EXPECT_EQ(read("remeshed")["message"], "");
}

}  // namespace
}  // namespace demolish::test
