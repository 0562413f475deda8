// SPDX-License-Identifier: Apache-2.0
// A glTF file as a scene: its nodes, its camera, its sun.
#include "app/session/set_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "app/bridge/host_frame.h"
#include "app/session/built_shot.h"
#include "app/session/scene_file.h"
#include "app/session/shot_bodies.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A table of 2 x 1 x 1 m on the floor, a cup of 0.2 m on it, a wall, a group of two posts, and below the
/// cup a node without a mesh; a camera before it all and a sun from above.
const char* const kNodes = R"([
{"name":"table","mesh":0,"translation":[0,0.5,0],"scale":[2,1,1],"children":[1]},
{"name":"cup \"a\"","mesh":0,"translation":[0.25,0.6,0],"scale":[0.1,0.2,0.2],"children":[2]},
{"name":"handle"},
{"name":"collider_wall","mesh":0,"translation":[0,1,-2],"scale":[4,2,0.2]},
{"name":"collider_posts","children":[5,6]},
{"name":"left","mesh":0,"translation":[-2,1,0],"scale":[0.2,2,0.2]},
{"name":"right","mesh":0,"translation":[2,1,0],"scale":[0.2,2,0.2]},
{"name":"view","camera":0,"translation":[0.5,1.1,4]},
{"name":"sun","rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":0}}}])";
const char* const kMore =
    R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"aspectRatio":1.5,"znear":0.1}}],
"extensionsUsed":["KHR_lights_punctual"],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":3}]}})";

class SetScene : public testing::Test {
  protected:
    std::filesystem::path set(const std::string& nodes = kNodes, const std::string& scene = "[0,3,4,7,8]",
                              const std::string& more = kMore,
                              const std::vector<test::GltfNumbers>& numbers = {}) {
        return test::writeGltfSet(folder_.path(), "set.gltf", nodes, scene, more, numbers);
    }
    Shot split(const std::filesystem::path& file, const SetSize& size = {}) {
        Shot shot = splitShot(file, size);
        shot.device = DeviceChoice::kCpu;
        return shot;
    }
    test::TemporaryFolder folder_;
};

TEST_F(SetScene, NodesAreBodiesWithTheirNamesAtTheirPlaces) {
    Shot shot = split(set());
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_EQ(shot.bodies[0].name, "table");
    EXPECT_EQ(shot.bodies[1].name, "cup \"a\"");
    EXPECT_EQ(shot.impact.body, 1u) << "in the middle of the picture";
    EXPECT_EQ(partOf(shot, shot.bodies[0]).node, "table");
    shot.fineness.particles = 40;
    const BuiltShot built = prepareShot(shot, {.draw_geometry = false}, {});
    EXPECT_EQ(built.cells.meshes.size(), 2u);
    const BodyInstance &table = built.setup.bodies[0], &cup = built.setup.bodies[1];
    EXPECT_NEAR(table.body->bounds_max.x - table.body->bounds_min.x, 2, 1e-6);
    EXPECT_NEAR(table.position.y, 0, 1e-6);
    EXPECT_NEAR(cup.position.x, 0.5, 1e-6) << "a child of the table, in its scale";
    EXPECT_NEAR(cup.position.y, 1, 1e-6);
    for (const double side :
         {cup.body->bounds_max.x - cup.body->bounds_min.x, cup.body->bounds_max.y - cup.body->bounds_min.y,
          cup.body->bounds_max.z - cup.body->bounds_min.z})
        EXPECT_NEAR(side, 0.2, 1e-6);
    EXPECT_FALSE(built.shot.impact.times_threshold) << "found when the body was there";
}

TEST_F(SetScene, NamesMakeColliders) {
    const Shot shot = split(set());
    ASSERT_EQ(shot.colliders.size(), 2u) << "the wall, and both posts as one";
    const auto& posts = std::get<MeshShape>(shot.colliders[1].shape);
    EXPECT_EQ(posts.mesh->corners.size(), 2u * 12 * 3 * 6);
    std::string many = "[{\"name\":\"vase\",\"mesh\":0}", roots = "[0";
    for (int i = 1; i <= 8; ++i) {
        many.append(",{\"name\":\"collider_").append(std::to_string(i)).append("\",\"mesh\":0}");
        roots.append(",").append(std::to_string(i));
    }
    try {
        split(set(many + "]", roots + "]", ""));
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("8 nodes named collider_...; at most 7"));
    }
}

/// A beam of 2 m whose left end lies in an anchor, in the air: it falls without one.
TEST_F(SetScene, AnAnchorHoldsWhatLiesInItsBox) {
    const std::string beam = R"([{"name":"beam","mesh":0,"translation":[0,2,0],"scale":[2,0.3,0.3]})";
    const std::string anchor =
        R"(,{"name":"anchor_left","mesh":0,"translation":[-0.9,2,0],"scale":[0.4,0.5,0.5]}])";
    double height[2] = {};
    for (const bool held : {false, true}) {
        Shot shot = held ? split(set(beam + anchor, "[0,1]", "")) : split(set(beam + "]", "[0]", ""));
        ASSERT_EQ(shot.bodies.size(), 1u);
        EXPECT_EQ(shot.anchors.size(), held ? 1u : 0u);
        shot.impact.kind = ImpactKind::kNone;
        shot.fineness.particles = 60;
        const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
        for (int frame = 0; frame < 12; ++frame) ASSERT_EQ(built.solver->advanceFrame(), StepStatus::kOk);
        double lowest = 1e9;
        for (const auto& particle : readFrame(*built.solver, FrameParts::kParticles).particles)
            lowest = std::min<double>(lowest, particle.position.y);
        height[held ? 1 : 0] = lowest;
    }
    EXPECT_LT(height[0], 1.8) << "0.2 m in 0.2 s";
    EXPECT_GT(height[1], 1.83) << "held";
}

TEST_F(SetScene, CameraAndSunAreTaken) {
    const Shot shot = split(set());
    ASSERT_TRUE(shot.camera);
    EXPECT_NEAR(shot.camera->eye.z, 4, 1e-5);
    EXPECT_NEAR(shot.camera->target.z, 3, 1e-5);
    EXPECT_NEAR(shot.camera->target.y, 1.1, 1e-5);
    EXPECT_NEAR(shot.camera->field_of_view, 0.7, 0.04) << "as exact as assimp";
    EXPECT_NEAR(shot.lighting.sun_direction.y, -1, 1e-5);
    EXPECT_NEAR(shot.impact.direction.z, -1, 1e-5) << "from the camera's side";
}

TEST_F(SetScene, TheSunShinesAsBrightAsTheFileSays) {
    const auto shine = [this](const char* light) {
        const std::string lights = std::string(R"(,"extensionsUsed":["KHR_lights_punctual"],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional",)") +
                                   light + "}]}}";
        return *split(set(R"([{"name":"box","mesh":0},
{"name":"sun","extensions":{"KHR_lights_punctual":{"light":0}}}])",
                          "[0,1]", lights))
                    .environment.sun_colour;
    };
    const glm::vec3 day = shine(R"("intensity":2049,"color":[1,0.5,0.25])");  // 3 W/m2
    EXPECT_NEAR(day.r, 3 / M_PI, 1e-4);
    EXPECT_NEAR(day.g, 1.5 / M_PI, 1e-4);
    EXPECT_NEAR(day.b, 0.75 / M_PI, 1e-4);
    EXPECT_NEAR(shine(R"("intensity":3)").g, 3 / M_PI, 1e-4) << "no daylight in lux: watts";
    EXPECT_EQ(shine(R"("intensity":1e30)").g, 1000) << "as much as a scene takes";
    EXPECT_EQ(shine(R"("intensity":0)").g, 0);
}

/// Its parent goes round the origin by a quarter in a second, then the camera itself rises by 2 m in one.
TEST_F(SetScene, AMovingCameraIsAPathThatTheShotFollows) {
    const float half = std::sqrt(0.5f);
    const auto file = set(R"([{"name":"box","mesh":0},{"name":"rig","children":[2]},
{"name":"eye","camera":0,"translation":[0,1,4]}])",
                          "[0,1]",
                          R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],
"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}],
"samplers":[{"input":2,"output":3}]},
{"channels":[{"sampler":0,"target":{"node":2,"path":"translation"}}],"samplers":[{"input":4,"output":5}]}])",
                          {{"SCALAR", {0, 1}},
                           {"VEC4", {0, 0, 0, 1, 0, half, 0, half}},
                           {"SCALAR", {1, 2}},
                           {"VEC3", {0, 1, 4, 0, 3, 4}}});
    const Shot shot = split(file);
    const auto at = [&shot](double time) { return cameraAt(*shot.camera, shot.camera_path, time); };
    for (const double time : {0.0, 0.2, 0.5, 0.83, 1.0}) {
        const double angle = time * M_PI / 2;
        EXPECT_NEAR(at(time).eye.x, 4 * std::sin(angle), 0.01) << time;
        EXPECT_NEAR(at(time).eye.z, 4 * std::cos(angle), 0.01) << time;
        EXPECT_NEAR(at(time).direction().x, -std::sin(angle), 0.003) << time;
    }
    EXPECT_NEAR(at(1.5).eye.y, 2.5, 0.01) << "lifted by the box's half below the floor";
    EXPECT_NEAR(at(9).eye.y, 3.5, 1e-4) << "and stays";
    EXPECT_LT(shot.camera_path.size(), 40u) << "as few keys as tell it";
    EXPECT_TRUE(split(set()).camera_path.empty()) << "one that stands has none";
}

/// It rolls by a quarter in a second, to the left as seen from behind it.
TEST_F(SetScene, ARollingCameraTakesItsUpAlong) {
    const float half = std::sqrt(0.5f);
    const auto file =
        set(R"([{"name":"box","mesh":0},{"name":"eye","camera":0,"translation":[0,1,4]}])", "[0,1]",
            R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}],
"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}],
"samplers":[{"input":2,"output":3}]}])",
            {{"SCALAR", {0, 1}}, {"VEC4", {0, 0, 0, 1, 0, 0, half, half}}});
    const Shot shot = split(file);
    const auto at = [&shot](double time) { return cameraAt(*shot.camera, shot.camera_path, time); };
    for (const double time : {0.0, 0.3, 0.5, 1.0}) {
        const double angle = time * M_PI / 2;
        const glm::vec3 up = glm::normalize(at(time).up);
        EXPECT_NEAR(up.x, -std::sin(angle), 0.003) << time;
        EXPECT_NEAR(up.y, std::cos(angle), 0.003) << time;
        EXPECT_NEAR(at(time).direction().z, -1, 1e-5) << time;
    }
    EXPECT_LT(shot.camera_path.size(), 30u);
    EXPECT_THAT(sceneTextOf(file, {}, folder_.path() / "a.toml"), HasSubstr("up = [0, 1, 0]"));
    EXPECT_THAT(sceneTextOf(set(), {}, folder_.path() / "a.toml"), Not(HasSubstr("up = ")))
        << "one that stands upright says nothing";
}

TEST_F(SetScene, AHeightScalesAllOfTheSet) {
    const Shot plain = split(set()), shot = split(set(), {{}, 2.4});
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_NEAR(shot.height, 2, 1e-6) << "the cup's top was at 1.2 m";
    const MeshPlacement table = placementOf(shot, shot.bodies[0]);
    EXPECT_TRUE(table.keep_units);
    EXPECT_NEAR(table.height, 2, 1e-6);
    EXPECT_NEAR(shot.height * shot.bodies[1].position.y, 2, 1e-5);
    EXPECT_NEAR(shot.camera->eye.z, 8, 1e-5);
    const auto wall = [](const Shot& of) {
        return of.height * std::get<MeshShape>(of.colliders[0].shape).scale;
    };
    EXPECT_NEAR(wall(shot), 2 * wall(plain), 1e-6);
    Shot small = shot;
    small.fineness.particles = 40;
    const BuiltShot built = prepareShot(small, {.draw_geometry = false}, {});
    EXPECT_NEAR(built.setup.bodies[0].body->bounds_max.x - built.setup.bodies[0].body->bounds_min.x, 4, 1e-5);
    EXPECT_THROW(split(set(), {{}, 1000.0}), UsageError);
    const auto unknown = folder_.write("one.obj",
                                       "o a\nv 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\n"
                                       "f 2 3 4\nf 3 1 4\n");
    EXPECT_NEAR(split(unknown, {{}, 6.0}).height, 2, 1e-6) << "a height stands in for a unit";
}

TEST_F(SetScene, WhatLiesBelowTheFloorIsLiftedWithTheRest) {
    const Shot shot =
        split(set(R"([{"name":"a","mesh":0},{"name":"b","mesh":0,"translation":[3,2,0]}])", "[0,1]", ""));
    EXPECT_NEAR(shot.bodies[0].position.y, 0, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.y, 2, 1e-6);
}

/// By node and distance, not by a line of a text that nobody wrote.
TEST_F(SetScene, NodesFartherAwayThanASceneReachesAreNamed) {
    const auto file =
        set(R"([{"name":"near","mesh":0},{"name":"far","mesh":0,"translation":[20000,0,0]}])", "[0,1]", "");
    try {
        split(file);
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the node 'far' would lie 20000 m from the origin; 10000 m are"));
    }
    EXPECT_EQ(split(file, {{}, 1000.0}).bodies.size(), 2u) << "scaled to be 1 km long";
}

TEST_F(SetScene, AFormatWithoutAUnitNeedsOneAndMayPointUpwardsByZ) {
    const auto file =
        folder_.write("two.obj",
                      "o low\nv 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
                      "o high\nv 9 0 5\nv 11 0 5\nv 9 3 5\nv 9 0 9\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n");
    try {
        split(file);
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("'two.obj' does not say its unit: give --unit"));
    }
    const Shot shot = split(file, {{"", UpAxis::kZ, 0.01}, {}});
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_EQ(shot.bodies[1].name, "high");
    EXPECT_NEAR(shot.bodies[1].position.x, 0.1, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.y, 0.05, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.z, -0.015, 1e-9);
    EXPECT_EQ(partOf(shot, shot.bodies[1]), (ModelPart{"high", UpAxis::kZ, 0.01}));
    EXPECT_TRUE(placementOf(shot, shot.bodies[1]).keep_units);
}

TEST_F(SetScene, TheSceneFileIsTheSameShot) {
    const auto model =
        set(kNodes, "[0,3,4,7,8]", std::string(kMore) + R"(,"animations":[{"channels":[{"sampler":0,
"target":{"node":7,"path":"translation"}}],"samplers":[{"input":2,"output":3}]}])",
            {{"SCALAR", {0, 1.5}}, {"VEC3", {0.5, 1.1, 4, 2, 1.1, 4}}});
    const SetSize size{{}, 3.0};
    std::filesystem::create_directory(folder_.path() / "shots");
    const auto file = folder_.path() / "shots" / "my_shot.toml";
    std::ofstream(file) << sceneTextOf(model, size, file);
    Shot written = loadSceneFile(file);
    const Shot direct = splitShot(model, size);
    EXPECT_TRUE(std::filesystem::equivalent(written.model, direct.model));
    written.model = direct.model;
    for (SceneBody& body : written.bodies)
        if (body.model) body.model = direct.model;
    written.scene = direct.scene;
    written.scene_file = direct.scene_file;
    written.colliders = direct.colliders;  // meshes of their own reading
    EXPECT_TRUE(written == direct);
    EXPECT_EQ(written.camera_path.size(), 1u);
    EXPECT_TRUE(written.environment.sun_colour);
}

}  // namespace
}  // namespace demolish
