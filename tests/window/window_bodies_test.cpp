// SPDX-License-Identifier: Apache-2.0
// A set in the window: bodies chosen, hidden, dragged, of another material; the report of an import and its
// choices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "engine/scene/camera.h"
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
                            "[camera]\neye_m = [0, 0.8, 2.6]\ntarget_m = [0, 0.25, 0]\n"
                            "field_of_view_deg = 40\n")
                     .string();
        camera_.eye = {0, 0.8f, 2.6f};
        camera_.target = {0, 0.25f, 0};
        camera_.field_of_view = glm::radians(40.0f);
    }
    /// Of a point (m) in the picture, as shares of it; without panels it is the whole window of 900 x 640.
    glm::vec2 at(const glm::dvec3& point) const {
        const glm::vec4 p =
            camera_.projection(900.0f / 640.0f) * camera_.view() * glm::vec4(glm::vec3(point), 1);
        return {0.5f + 0.5f * p.x / p.w, 0.5f - 0.5f * p.y / p.w};
    }
    static std::string dragged(const glm::vec2& from, const glm::vec2& to, const std::string& name) {
        std::ostringstream text;
        text << "move_picture " << from.x << ' ' << from.y << ' ' << to.x << ' ' << to.y
             << "\nuntil rebuilt\nwait 2\nscreenshot " << name << "\nstate " << name << '\n';
        return text.str();
    }
    /// Of the right body, in the state of that name.
    std::vector<double> place(const std::string& name) const {
        return read(name)["bodies"][1]["position_m"].get<std::vector<double>>();
    }
    double yaw(const std::string& name) const { return read(name)["bodies"][1]["yaw_rad"].get<double>(); }

    engine::Camera camera_;
};

constexpr const char* kRightOneChosen =
    "wait 2\nkey space\nkey r\nclick bodies.arrange\nclick bodies.name.1\nkey tab\nwait 2\n";

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

TEST_F(WindowBodies, AnArrowMovesAlongItsAxisAndTheRingTurns) {
    const glm::dvec3 foot(0.6, 0, 0), right(1, 0, 0), up(0, 1, 0);
    const double far = glm::distance(foot, glm::dvec3(camera_.eye)), tip = 0.12 * far, ring = 0.075 * far;
    const auto on_ring = [&](double degrees) {
        const double angle = glm::radians(degrees);
        return foot + ring * glm::dvec3(std::cos(angle), 0, -std::sin(angle));
    };
    const glm::dvec3 raised = foot + 0.4 * up;
    run(kRightOneChosen + dragged(at(foot + tip * up), at(foot + (tip + 0.4) * up), "28_raised") +
        dragged(at(raised + tip * right), at(raised + (tip + 0.25) * right), "29_aside"));
    if (HasFatalFailure()) return;
    EXPECT_NEAR(place("28_raised")[1], 0.4, 0.01);
    EXPECT_NEAR(place("28_raised")[0], 0.6, 1e-6) << "along its axis alone";
    EXPECT_NEAR(place("28_raised")[2], 0, 1e-6);
    EXPECT_NEAR(place("29_aside")[0], 0.85, 0.01);
    EXPECT_NEAR(place("29_aside")[1], place("28_raised")[1], 1e-6);
    EXPECT_NEAR(yaw("29_aside"), 0, 1e-9);
    run(kRightOneChosen + dragged(at(on_ring(-60)), at(on_ring(-25)), "30_turned"));
    if (HasFatalFailure()) return;
    EXPECT_NEAR(yaw("30_turned"), glm::radians(35.0), 0.06) << "a pixel of the ring is 2 degrees there";
    EXPECT_NEAR(place("30_turned")[0], 0.6, 1e-6) << "it turns where it stands";
    EXPECT_NEAR(place("30_turned")[1], 0, 1e-6);
}

TEST_F(WindowBodies, WhatIsDraggedOntoAnotherStandsOnIt) {
    // Taken by its front. Its foot goes over the picture as the mouse does: onto the other's top.
    const glm::vec2 front = at({0.6, 0.3, 0.25}), way = at({-0.6, 0.5, 0.1}) - at({0.6, 0, 0});
    run(kRightOneChosen + dragged(front, front + way, "31_stacked"));
    if (HasFatalFailure()) return;
    EXPECT_NEAR(place("31_stacked")[0], -0.6, 0.02);
    EXPECT_NEAR(place("31_stacked")[1], 0.5, 0.01);
    EXPECT_NEAR(place("31_stacked")[2], 0.1, 0.02);
    EXPECT_EQ(read("31_stacked")["bonds_broken"], 0);
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
    EXPECT_THAT(read("loaded")["size_remark"].get<std::string>(), HasSubstr("'Unit of the file'"));
    EXPECT_EQ(read("unit")["size_remark"], "");
    EXPECT_NEAR(read("unit")["body_size"].get<double>(), 0.4, 1e-6);
    EXPECT_THAT(read("refused")["message"].get<std::string>(), HasSubstr("is not closed"));
    EXPECT_EQ(read("refused")["repair"], "auto") << "what cannot be made is not kept";
    EXPECT_EQ(read("remeshed")["repair"], "remesh");
    EXPECT_EQ(read("remeshed")["message"], "");
}

/// A block of vertex colours without red, with as much green as there may be: painted by red it is weak, by
/// green as strong as it is unpainted. States are of one moment: how far a shot comes in so many turns of the
/// window depends on how busy the machine is.
TEST_F(WindowProgram, PaintedColoursAreChosenAndWeaken) {
    const std::string red_is_dark =
        "v 0 0 0 0 1 0.5\nv 0 0 1 0 1 0.5\nv 1 0 1 0 1 0.5\nv 1 0 0 0 1 0.5\n"
        "v 0 1 0 0 1 0.5\nv 0 1 1 0 1 0.5\nv 1 1 1 0 1 0.5\nv 1 1 0 0 1 0.5\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 2 6 5 1\nf 3 7 6 2\nf 4 8 7 3\nf 1 5 8 4\n";
    const std::string file = folder_.write("painted.obj", red_is_dark).string();
    const auto shot = [](const std::string& name) {
        return "key r\nwait 2\nkey space\nwait 60\nkey space\nwait 2\ntype transport.timeline 24\nwait "
               "2\nstate " +
               name + "\nscreenshot 32_" + name + "\n";
    };
    const auto choose = [](const std::string& channel) {
        return "click particles.painted\nclick particles.painted." + channel +
               "\nwait 2\nuntil rebuilt\nwait 2\n";
    };
    run("wait 2\nkey space\nclick transport.real_time\ntype shot.model " + file +
            "\nwait 3\nuntil rebuilt\nwait 3\n" + shot("plain") + choose("red") + shot("red") +
            choose("green") + shot("green"),
        {}, 200);
    if (HasFatalFailure()) return;
    EXPECT_EQ(read("plain")["painted"], "");
    EXPECT_EQ(read("red")["painted"], "red");
    EXPECT_EQ(read("green")["painted"], "green");
    const auto broken = [&](const std::string& name) { return read(name)["bonds_broken"].get<int>(); };
    EXPECT_EQ(broken("green"), broken("plain")) << "as strong as it is where the colour is full";
    EXPECT_GT(broken("red"), broken("plain")) << "a tenth as strong where it is dark";
    for (const char* name : {"red", "green"}) EXPECT_EQ(read(name)["time"], read("plain")["time"]) << name;
    EXPECT_EQ(read("plain")["replaying"], true);
    for (const char* name : {"plain", "red", "green"}) {
        EXPECT_EQ(read(name)["message"], "") << name;
        EXPECT_EQ(read(name)["particles"], read("plain")["particles"]) << name;
    }
}

}  // namespace
}  // namespace demolish::test
