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
                              const std::string& more = kMore) {
        return test::writeGltfSet(folder_.path(), "set.gltf", nodes, scene, more);
    }
    Shot split(const std::filesystem::path& file, const ModelPart& part = {}) {
        Shot shot = splitShot(file, part);
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

TEST_F(SetScene, WhatLiesBelowTheFloorIsLiftedWithTheRest) {
    const Shot shot =
        split(set(R"([{"name":"a","mesh":0},{"name":"b","mesh":0,"translation":[3,2,0]}])", "[0,1]", ""));
    EXPECT_NEAR(shot.bodies[0].position.y, 0, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.y, 2, 1e-6);
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
    const Shot shot = split(file, {"", UpAxis::kZ, 0.01});
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_EQ(shot.bodies[1].name, "high");
    EXPECT_NEAR(shot.bodies[1].position.x, 0.1, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.y, 0.05, 1e-9);
    EXPECT_NEAR(shot.bodies[1].position.z, -0.015, 1e-9);
    EXPECT_EQ(partOf(shot, shot.bodies[1]), (ModelPart{"high", UpAxis::kZ, 0.01}));
    EXPECT_TRUE(placementOf(shot, shot.bodies[1]).keep_units);
}

TEST_F(SetScene, TheSceneFileIsTheSameShot) {
    const auto model = set();
    std::filesystem::create_directory(folder_.path() / "shots");
    const auto file = folder_.path() / "shots" / "my_shot.toml";
    std::ofstream(file) << sceneTextOf(model, {}, file);
    Shot written = loadSceneFile(file);
    const Shot direct = splitShot(model, {});
    EXPECT_TRUE(std::filesystem::equivalent(written.model, direct.model));
    written.model = direct.model;
    for (SceneBody& body : written.bodies)
        if (body.model) body.model = direct.model;
    written.scene = direct.scene;
    written.scene_file = direct.scene_file;
    written.colliders = direct.colliders;  // meshes of their own reading
    EXPECT_TRUE(written == direct);
}

}  // namespace
}  // namespace demolish
