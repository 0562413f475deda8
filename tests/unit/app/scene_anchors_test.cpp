// SPDX-License-Identifier: Apache-2.0
// Anchors, paths, cables and mortar in scene files: what is read, where it stands in the world, what is
// refused.
#include "app/session/scene_anchors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/session/cables.h"
#include "app/session/scene_file.h"
#include "tests/unit/app/scene_texts.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish {
namespace {

using test::complaintAbout;
using test::kHead;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kSet = kHead +
                         "height_m = 0.5\n"
                         "body = [\n"
                         "  { anchor = [{ shape = \"sphere\", radius_m = 0.1, position_m = [0.2, 0, 0] }], "
                         "position_m = [1, 0, 0], rotation_deg = [0, 90, 0] },\n"
                         "  { breaks = false, position_m = [0, 2, 0], path_motion = \"smooth\", "
                         "    path = [{ at_s = 0.5, position_m = [0, -1, 0] }, { at_s = 1, rotation_deg = "
                         "[0, 0, 720] }] },\n"
                         "]\n"
                         "[[anchor]]\nshape = \"box\"\nsize_m = [1, 0.1, 1]\nposition_m = [0, -0.05, 0]\n"
                         "body = 0\n";

TEST(SceneAnchors, OfTheSceneAndOfItsBodiesAreReadAndPlaced) {
    const TemporaryFolder folder;
    const Shot shot = loadSceneFile(folder.write("set.toml", kSet));
    std::vector<BodyInstance> bodies(2);
    bodies[0].position = {1, 0, 0};
    bodies[0].rotation = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // x looks along -z
    bodies[1].position = {0, 2, 0};
    const std::vector<Anchor> anchors = anchorsOf(shot, bodies);
    ASSERT_EQ(anchors.size(), 3u);
    const Box& ground = std::get<Box>(anchors[0].region);
    EXPECT_NEAR(ground.size.y, 0.1, 1e-12);
    EXPECT_NEAR(ground.position.y, -0.05, 1e-12);
    EXPECT_EQ(anchors[0].body, 0u);
    EXPECT_TRUE(anchors[0].path.keys.empty());
    const Sphere& ball = std::get<Sphere>(anchors[1].region);
    EXPECT_NEAR(ball.radius, 0.1, 1e-12);
    EXPECT_NEAR(ball.position.x, 1, 1e-12);
    EXPECT_NEAR(ball.position.z, -0.2, 1e-12);
    EXPECT_EQ(anchors[1].body, 0u);
    ASSERT_EQ(anchors[2].path.keys.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<Anchor::Everything>(anchors[2].region));
    EXPECT_EQ(anchors[2].body, 1u);
    EXPECT_TRUE(anchors[2].path.smooth);
    EXPECT_NEAR(anchors[2].path.keys[0].way.y, -1, 1e-12);
    EXPECT_NEAR(anchors[2].path.keys[1].turn.z, 4 * M_PI, 1e-12);
    EXPECT_NEAR(anchors[2].pivot.y, 2, 1e-12);
}

/// A table of 2 x 1 x 1 m on the floor of its file at (3, 0, 1), and a cube of 0.2 m whose middle is 1.1 m
/// above the floor, 0.5 m beside the table's.
void writeTable(const TemporaryFolder& folder) {
    test::writeGltfSet(folder.path(), "set.gltf",
                       R"([{"name":"table","mesh":0,"translation":[3,0.5,1],"scale":[2,1,1]},
{"name":"hand","mesh":0,"translation":[3.5,1.1,1],"scale":[0.2,0.2,0.2]}])",
                       "[0,1]");
}

TEST(SceneAnchors, ANodeOfTheBodysFileHoldsWhereItLiesOnTheBody) {
    const TemporaryFolder folder;
    writeTable(folder);
    const std::string own = "node = \"table\", anchor = [{ shape = \"node\", node = \"hand\" }]";
    const std::string head = "version = 1\nmodel = \"set.gltf\"\n";
    const Shot kept = loadSceneFile(folder.write("kept.toml", head + "body = [{ " + own + " }]\n"));
    const Box& box = std::get<Box>(kept.bodies.at(0).anchors.at(0).region);
    EXPECT_NEAR(box.position.x, 0.5, 1e-6) << "from the middle of the table's foot";
    EXPECT_NEAR(box.position.y, 1.1, 1e-6);
    EXPECT_NEAR(box.position.z, 0, 1e-6);
    EXPECT_NEAR(box.size.y, 0.2, 1e-6);
    const Shot tall =
        loadSceneFile(folder.write("tall.toml", head + "body = [{ height_m = 2, " + own + " }]\n"));
    const Box& larger = std::get<Box>(tall.bodies.at(0).anchors.at(0).region);
    EXPECT_NEAR(larger.position.y, 2.2, 1e-6);
    EXPECT_NEAR(larger.size.x, 0.4, 1e-6);
}

TEST(SceneAnchors, ANodeOfAFileHoldsInTheSceneWhereItLiesInItsFile) {
    const TemporaryFolder folder;
    writeTable(folder);
    const Shot shot = loadSceneFile(folder.write(
        "scene.toml", kHead + "[[anchor]]\nshape = \"node\"\nmodel = \"set.gltf\"\nnode = \"hand\"\n"
                              "position_m = [0, 1, 0]\nrotation_deg = [0, 90, 0]\nscale = 2\n"));
    const Box& box = std::get<Box>(shot.anchors.at(0).region);
    EXPECT_NEAR(box.position.x, 2, 1e-6) << "z comes to x";
    EXPECT_NEAR(box.position.y, 3.2, 1e-6);
    EXPECT_NEAR(box.position.z, -7, 1e-6);
    EXPECT_NEAR(box.size.z, 0.4, 1e-6);
    EXPECT_NEAR(box.rotation.y, std::sqrt(0.5), 1e-6);
}

TEST(SceneAnchors, ANodeThatIsNotThereIsRefusedWithThoseThatAre) {
    const TemporaryFolder folder;
    writeTable(folder);
    const auto complaint = [&folder](const std::string& keys) -> std::string {
        try {
            loadSceneFile(folder.write("scene.toml",
                                       "version = 1\nmodel = \"set.gltf\"\nbody = [\n{ node = "
                                       "\"table\", anchor = [{ shape = \"node\"" +
                                           keys + " }] }]\n"));
        } catch (const InputFileError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(complaint(""), HasSubstr("scene.toml:4: body[0].anchor[0].node is missing"));
    EXPECT_THAT(complaint(", node = \"claw\""),
                testing::AllOf(HasSubstr("scene.toml:4: body[0].anchor[0].node is wrong"),
                               HasSubstr("has no node 'claw'"), HasSubstr("table, hand")));
    EXPECT_THAT(complaint(", node = \"hand\", model = \"set.gltf\""),
                HasSubstr("there is no setting 'body[0].anchor[0].model'"));
    EXPECT_THAT(complaintAbout("version = 1\nbody = [{ model = \"models/block.obj\" }]\n[[anchor]]\nshape = "
                               "\"node\"\nnode = \"a\"\n"),
                HasSubstr("anchor[0].model is missing"));
}

std::string body(const std::string& keys) {
    return kHead + "body = [{ " + keys + " }]\n";
}

TEST(SceneAnchors, WhatIsWrongIsRefusedWithItsKey) {
    EXPECT_THAT(complaintAbout(kHead + "[[anchor]]\nsize_m = [1, 1, 1]\n"),
                HasSubstr("scene.toml:3: anchor[0].shape is missing"));
    EXPECT_THAT(complaintAbout(kHead + "[[anchor]]\nshape = \"plane\"\n"),
                HasSubstr("anchor[0].shape must be one of"));
    EXPECT_THAT(complaintAbout(kHead + "[[anchor]]\nshape = \"sphere\"\n"),
                HasSubstr("anchor[0].radius_m is missing"));
    EXPECT_THAT(complaintAbout(kHead + "[[anchor]]\nshape = \"sphere\"\nradius_m = 1\nbody = 1\n"),
                HasSubstr("anchor[0].body must be 0"));
    EXPECT_THAT(complaintAbout(body("path = [{ at_s = 1 }]")),
                HasSubstr("scene.toml:3: body[0].path needs breaks = false"));
    EXPECT_THAT(complaintAbout(body("breaks = false, path = [{ at_s = 0 }]")),
                HasSubstr("body[0].path[0].at_s must be above 0"));
    EXPECT_THAT(complaintAbout(body("breaks = false, path = [{ at_s = 2 }, { at_s = 1 }]")),
                HasSubstr("body[0].path[1].at_s must be later"));
    EXPECT_THAT(complaintAbout(body("breaks = false, path = [{ position_m = [0, 1, 0] }]")),
                HasSubstr("body[0].path[0].at_s is missing"));
    EXPECT_THAT(complaintAbout(body("breaks = false, path = [{ at_s = 1 }], path_motion = \"fast\"")),
                HasSubstr("body[0].path_motion must be \"linear\" or \"smooth\""));
    EXPECT_THAT(complaintAbout(body("path_motion = \"smooth\"")), HasSubstr("is of no use without a path"));
    EXPECT_THAT(complaintAbout(body("breaks = false, path = [{ at_s = 1 }], velocity_mps = [1, 0, 0]")),
                HasSubstr("body[0].velocity_mps and path exclude each other"));
    EXPECT_THAT(complaintAbout(body("anchor = [{ shape = \"sphere\", radius_m = 1, body = 0 }]")),
                HasSubstr("there is no setting 'body[0].anchor[0].body'"));
}

/// From a hook 3 m up to the upper side of what swings below it, both in a scene of half a metre's height.
TEST(SceneCables, AreStretchedFromTheirPlaceToTheBodyWhereverItsPathIs) {
    const TemporaryFolder folder;
    const auto body = [](const std::string& keys) {
        return kHead + "height_m = 0.5\nbody = [{ position_m = [0, 1, 0], " + keys + " }]\n";
    };
    const std::string path =
        "breaks = false, path = [{ at_s = 2, position_m = [2, 0, 0], rotation_deg = [0, 0, 180] }]";
    const Shot shot = loadSceneFile(folder.write(
        "cable.toml", body(path + ", cable = { at_m = [0, 0.5, 0], to_m = [0, 3, 0], radius_m = 0.02 }")));
    const auto end = [](const engine::ColliderDraw& rod, float side) {
        return rod.position + rod.rotation * glm::vec3(0, 0, side * rod.half_size.z);
    };
    for (const auto& [time, x, y] : {std::tuple(0.0, 0.0f, 1.5f), {1.0, 0.5f, 1.0f}, {9.0, 2.0f, 0.5f}}) {
        const auto drawn = drawnCables(shot, time);
        ASSERT_EQ(drawn.size(), 1u);
        EXPECT_NEAR(drawn[0].half_size.x, 0.02f, 1e-6f);
        const bool first_is_hook = end(drawn[0], -1).y > 2.5f;
        const glm::vec3 hook = end(drawn[0], first_is_hook ? -1.0f : 1.0f),
                        eye = end(drawn[0], first_is_hook ? 1.0f : -1.0f);
        EXPECT_NEAR(glm::distance(hook, glm::vec3(0, 3, 0)), 0, 1e-5f) << time;
        EXPECT_NEAR(glm::distance(eye, glm::vec3(x, y, 0)), 0, 1e-5f) << time;
    }
    EXPECT_EQ(drawnCables(shot, 1), drawnCables(shot, 1)) << "a still picture stays the same";
    Shot hidden = shot;
    hidden.bodies[0].hidden = true;
    EXPECT_TRUE(drawnCables(hidden, 0).empty());
    EXPECT_THAT(complaintAbout(body("cable = { to_m = [0, 3, 0] }")),
                HasSubstr("body[0].cable needs a path"));
    EXPECT_THAT(complaintAbout(body(path + ", cable = { at_m = [0, 3, 0] }")),
                HasSubstr("body[0].cable.to_m is missing"));
    EXPECT_THAT(complaintAbout(body(path + ", cable = { to_m = [0, 3, 0], radius_m = 0 }")),
                HasSubstr("body[0].cable.radius_m must be"));
}

TEST(SceneMortar, IsReadAndRefusedWithItsKey) {
    const TemporaryFolder folder;
    const Shot shot = loadSceneFile(folder.write(
        "wall.toml", kHead + "height_m = 0.5\n[mortar]\ntensile_strength_pa = 4e5\njoint_m = 0.001\n"));
    ASSERT_TRUE(shot.mortar);
    EXPECT_EQ(shot.mortar->tensile_strength, 4e5);
    EXPECT_NEAR(shot.mortar->joint, 0.002, 1e-12) << "in heights of the bodies";
    EXPECT_FALSE(loadSceneFile(folder.write("dry.toml", kHead)).mortar);
    EXPECT_THAT(complaintAbout(kHead + "[mortar]\njoint_m = 0.001\n"),
                HasSubstr("scene.toml:3: mortar.tensile_strength_pa is missing"));
    EXPECT_THAT(complaintAbout(kHead + "[mortar]\ntensile_strength_pa = -1\n"),
                HasSubstr("mortar.tensile_strength_pa must be a number between"));
    EXPECT_THAT(complaintAbout(kHead + "[mortar]\ntensile_strength_pa = 1e5\nstrength = 2\n"),
                HasSubstr("there is no setting 'mortar.strength'"));
}

}  // namespace
}  // namespace demolish
