// SPDX-License-Identifier: Apache-2.0
// Scene and material files: what is read, and what is refused with file and line.
#include "app/session/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/session/data_folder.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/scene_texts.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::complaintAbout;
using test::kHead;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(SceneFile, ReadsWhatIsWritten) {
    const TemporaryFolder folder;
    const auto file = folder.write("bowl.toml", kHead +
                                                    "height_m = 0.5\nmaterial_preset = \"glass\"\n"
                                                    "[material]\ntough_cells = 17\n"
                                                    "[particles]\nfull = 5000\ndraft = 300\nseed = 9\n"
                                                    "[impact]\nkind = \"drop\"\nvelocity_mps = 3.5\n"
                                                    "[camera]\neye_m = [1.0, 2, 3.5]\n"
                                                    "[look]\nexterior_colour = [0.1, 0.2, 0.3]\n");
    const Shot shot = loadSceneFile(file);
    EXPECT_EQ(shot.scene, "bowl");
    EXPECT_EQ(shot.model, dataFolder() / "assets/models/block.obj");
    EXPECT_DOUBLE_EQ(shot.height, 0.5);
    EXPECT_EQ(shot.material_name, "glass");
    EXPECT_DOUBLE_EQ(shot.material.density, 2500);  // from the preset
    EXPECT_EQ(shot.material.tough_cells, 17u);      // changed by the scene
    EXPECT_EQ(shot.fineness.full, 5000u);
    EXPECT_EQ(shot.seed, 9u);
    EXPECT_EQ(shot.impact.kind, ImpactKind::kDrop);
    EXPECT_DOUBLE_EQ(shot.impact.velocity, 3.5);
    ASSERT_TRUE(shot.camera.has_value());
    EXPECT_FLOAT_EQ(shot.camera->eye.z, 3.5f);
    EXPECT_FLOAT_EQ(shot.look.exterior_colour[1], 0.2f);
}

TEST(SceneFile, ReadsTheVelocityToBreakAt) {
    const TemporaryFolder folder;
    EXPECT_EQ(loadSceneFile(folder.write("a.toml", "break_at_mps = 6.5\n" + kHead)).break_at.value(), 6.5);
    EXPECT_FALSE(loadSceneFile(folder.write("b.toml", kHead)).break_at);
    EXPECT_THROW(loadSceneFile(folder.write("c.toml", "break_at_mps = -1\n" + kHead)), InputFileError);
}

TEST(SceneFile, ReadsHowItsModelIsRepaired) {
    const TemporaryFolder folder;
    const auto file = folder.write("leaf.toml", kHead + "repair = \"exact\"\nthickness_m = 0.02\n");
    EXPECT_EQ(loadSceneFile(file).repair, (RepairOptions{RepairMode::kExact, 0.02}));
    EXPECT_EQ(loadSceneFile(folder.write("plain.toml", kHead)).repair, RepairOptions{});
    EXPECT_THAT(complaintAbout(kHead + "repair = \"never\"\n"), HasSubstr("auto, exact, remesh, off"));
    EXPECT_THAT(complaintAbout(kHead + "thickness_m = -1\n"), HasSubstr("thickness_m"));
}

TEST(SceneFile, ReadsItsMethod) {
    const TemporaryFolder folder;
    const Shot shot =
        loadSceneFile(folder.write("cut.toml", kHead + "method = \"pattern\"\npattern = \"slabs\"\n"));
    EXPECT_EQ(shot.method, Method::kPattern);
    EXPECT_EQ(shot.pattern, Pattern::kSlabs);
    EXPECT_EQ(loadSceneFile(folder.write("plain.toml", kHead)).method, Method::kOurs);
    EXPECT_THAT(complaintAbout(kHead + "method = \"magic\"\n"), HasSubstr("ours, heavy, cores"));
    EXPECT_THAT(complaintAbout(kHead + "pattern = \"stars\"\n"), HasSubstr("uniform, radial"));
}

TEST(SceneFile, ReadsHowItsCellsLie) {
    const TemporaryFolder folder;
    const Shot plain = loadSceneFile(folder.write("plain.toml", kHead));
    EXPECT_FALSE(plain.conform);
    EXPECT_EQ(plain.refine, 1);
    EXPECT_FALSE(plain.pattern);
    const Shot shot =
        loadSceneFile(folder.write("cut.toml", "pattern = \"slabs\"\npattern_axis = [1, 0, 0]\n" + kHead +
                                                   "[particles]\nconform = true\nrefine = 2.5\n"
                                                   "painted = \"green\"\npainted_least = 0.3\n"));
    EXPECT_TRUE(shot.conform);
    EXPECT_EQ(shot.refine, 2.5);
    EXPECT_FALSE(plain.painted);
    EXPECT_EQ(shot.painted, (PaintedStrength{PaintChannel::kGreen, 0.3}));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\npainted = \"pink\"\n"), HasSubstr("red, green, blue"));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\npainted_least = 0.3\n"), HasSubstr("painted_least"));
    EXPECT_EQ(shot.pattern, Pattern::kSlabs);
    EXPECT_EQ(shot.pattern_axis, (Double3{1, 0, 0}));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\nrefine = 0.5\n"), HasSubstr("refine"));
    EXPECT_THAT(complaintAbout(kHead + "pattern_axis = [0, 0, 0]\n"), HasSubstr("points nowhere"));
}

TEST(SceneFile, NamesItsRowOfTheStrengthTable) {
    const TemporaryFolder folder;
    EXPECT_EQ(loadSceneFile(folder.write("block.toml", kHead)).strength_row, "");
    EXPECT_EQ(loadSceneFile(folder.write("a.toml", kHead + "strength_row = \"wolf\"\n")).strength_row,
              "wolf");
    EXPECT_THAT(complaintAbout(kHead + "strength_row = \"bear\"\n"),
                testing::AllOf(HasSubstr("scene.toml:3: strength_row must be one of"), HasSubstr("wolf")));
}

TEST(SceneFile, NamesFileAndLineOfAMistake) {
    EXPECT_THAT(complaintAbout(kHead + "height_m = \"tall\"\n"), HasSubstr("scene.toml:3"));
    EXPECT_THAT(complaintAbout(kHead + "\nheight_m = -1\n"),
                HasSubstr("scene.toml:4: height_m must be a number between"));
    EXPECT_THAT(complaintAbout(kHead + "height_m = nan\n"), HasSubstr("scene.toml:3"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\nvelocity = 3\n"),
                HasSubstr("there is no setting 'impact.velocity'"));
    EXPECT_THAT(complaintAbout(kHead + "height_cm = 30\n"), HasSubstr("is 'height_m' meant?"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\nvelocity_kmh = 3\n"),
                HasSubstr("is 'impact.velocity_mps' meant?"));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\nwater = 3\n"), HasSubstr("remove it or mend its name"));
    EXPECT_THAT(complaintAbout("version = 2\nmodel = \"models/block.obj\"\n"), HasSubstr("must be 1"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\nkind = \"kick\"\n"), HasSubstr("scene.toml:4"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\neye_m = [1, 2]\n"), HasSubstr("three numbers"));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\nfull = 10.5\n"), HasSubstr("whole number"));
    EXPECT_THAT(complaintAbout("version = 1\nmodel = \n"), HasSubstr("scene.toml:2"));
    EXPECT_THAT(complaintAbout(kHead + "material_preset = \"wood\"\n"),
                testing::AllOf(HasSubstr("scene.toml:3: material_preset"), HasSubstr("ceramic")));
    EXPECT_THROW(loadSceneFile("/no/such/scene.toml"), InputFileError);
}

TEST(SceneFile, ReadsBodiesBallsAndPhases) {
    const TemporaryFolder folder;
    const std::string bodies =
        "height_m = 0.5\nbody = [\n  { position_m = [1.0, 0, -2], yaw_deg = 90, variant = 1 },\n  {},\n]\n";
    const std::string balls =
        "[[ball]]\nat_s = 2.0\nbody = 1\nvelocity_mps = 6\ndirection = [0, 0, 1]\nflight_s = 0.3\n"
        "[[ball]]\nat_s = 0.5\nvelocity_mps = 3\nradius_m = 0.04\nheight_fraction = 0.8\n"
        "aim_m = [0, 0.4, 0.1]\n";
    const std::string phases =
        "[[phase]]\nname = \"whole\"\nto_s = 0.4\npaper_fps = 180\n"
        "[[phase]]\nname = \"all broken\"\nfrom_s = 2\nto_s = 3\n";
    const Shot shot = loadSceneFile(folder.write("two.toml", kHead + bodies + balls + phases));
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_DOUBLE_EQ(shot.bodies[0].position.x, 2) << "in heights of the body";
    EXPECT_DOUBLE_EQ(shot.bodies[0].position.z, -4);
    EXPECT_NEAR(shot.bodies[0].yaw, 1.5707963, 1e-6);
    EXPECT_EQ(shot.bodies[0].variant, 1u);
    EXPECT_DOUBLE_EQ(shot.impact.velocity, 6) << "of the fastest ball";
    ASSERT_EQ(shot.balls.size(), 2u);
    EXPECT_DOUBLE_EQ(shot.balls[0].arrival_time, 0.5) << "in order of time";
    EXPECT_DOUBLE_EQ(shot.balls[0].speed_share, 0.5);
    EXPECT_DOUBLE_EQ(shot.balls[0].radius.value(), 0.04);
    EXPECT_DOUBLE_EQ(shot.balls[0].height_fraction.value(), 0.8);
    EXPECT_FALSE(shot.balls[0].direction.has_value());
    EXPECT_DOUBLE_EQ(shot.balls[0].aim.value().y, 0.8) << "in heights of the body";
    EXPECT_FALSE(shot.balls[1].aim.has_value());
    EXPECT_EQ(shot.balls[1].body, 1u);
    EXPECT_DOUBLE_EQ(shot.balls[1].flight_time, 0.3);
    EXPECT_DOUBLE_EQ(shot.balls[1].direction.value().z, 1);
    ASSERT_EQ(shot.phases.size(), 2u);
    EXPECT_EQ(shot.phases[0].name, "whole");
    EXPECT_DOUBLE_EQ(shot.phases[0].paper_fps, 180);
    EXPECT_DOUBLE_EQ(shot.phases[1].from, 2);
    EXPECT_DOUBLE_EQ(shot.phases[1].to, 3);
}

TEST(SceneFile, RefusesListsThatMakeNoSense) {
    const std::string ball = "[[ball]]\nat_s = 1\nvelocity_mps = 5\n";
    EXPECT_EQ(complaintAbout(kHead + ball), "");
    EXPECT_THAT(complaintAbout(kHead + ball + "body = 1\n"), HasSubstr("scene.toml:6: ball[0].body must be"));
    EXPECT_THAT(complaintAbout(kHead + ball + "colour = 1\n"), HasSubstr("no setting 'ball[0].colour'"));
    EXPECT_THAT(complaintAbout(kHead + ball + "flight_s = 1.5\n"), HasSubstr("not be longer than at_s"));
    EXPECT_THAT(complaintAbout(kHead + "[[ball]]\nat_s = 1\n"), HasSubstr("ball[0].velocity_mps is missing"));
    EXPECT_THAT(complaintAbout(kHead + ball + "[impact]\nvelocity_mps = 0\n"), HasSubstr("must be above 0"));
    EXPECT_THAT(complaintAbout(kHead + "body = 3\n"), HasSubstr("body must be a list of tables"));
    EXPECT_THAT(complaintAbout(kHead + "body = [{ yaw_deg = 400 }]\n"), HasSubstr("body[0].yaw_deg"));
    const std::string phase = "[[phase]]\nname = \"whole\"\nfrom_s = 1\nto_s = 2\n";
    EXPECT_EQ(complaintAbout(kHead + phase), "");
    EXPECT_THAT(complaintAbout(kHead + phase + phase), HasSubstr("phase[1].from_s must not lie before"));
    EXPECT_THAT(complaintAbout(kHead + "[[phase]]\nname = \"a\"\n"), HasSubstr("later than from_s"));
    std::string many;
    for (int i = 0; i < 33; ++i) many += ball;
    EXPECT_THAT(complaintAbout(kHead + many), HasSubstr("ball has 33 entries; at most 32"));
}

/// A key that says no angle keeps that of the key before it.
TEST(SceneFile, AnglesOfACameraChangeAlongItsPath) {
    const TemporaryFolder folder;
    const Shot shot = loadSceneFile(folder.write("zoom.toml", kHead + R"([camera]
eye_m = [0, 1, 4]
target_m = [0, 1, 0]
field_of_view_deg = 60
path = [{ at_s = 1, field_of_view_deg = 20 }, { at_s = 2, eye_m = [0, 1, 2] }, { at_s = 4, field_of_view_deg = 40 }]
)"));
    const auto degrees = [&](double time) {
        return cameraAt(*shot.camera, shot.camera_path, time).field_of_view * 180 / M_PI;
    };
    EXPECT_NEAR(degrees(0), 60, 1e-4);
    EXPECT_NEAR(degrees(0.25), 50, 1e-4);
    EXPECT_NEAR(degrees(1), 20, 1e-4);
    EXPECT_NEAR(degrees(1.5), 20, 1e-4);
    EXPECT_NEAR(degrees(3), 30, 1e-4);
    EXPECT_NEAR(degrees(9), 40, 1e-4) << "and stays";
    EXPECT_NEAR(cameraAt(*shot.camera, shot.camera_path, 1.5).eye.z, 3, 1e-5);
    EXPECT_EQ(cameraAt(*shot.camera, {}, 1.5).field_of_view, shot.camera->field_of_view);
}

TEST(SceneFile, RefusesCameraAndLightThatShowNothing) {
    EXPECT_THAT(complaintAbout(kHead + "[light]\nsun_direction = [0, 0, 0]\n"),
                HasSubstr("scene.toml:4: light.sun_direction must have a length"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\neye_m = [1, 2, 3]\ntarget_m = [1, 2, 3]\n"),
                HasSubstr("scene.toml:4: camera.eye_m must be apart from camera.target_m"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\neye_m = [0, 0, 3]\ntarget_m = [0, 0, 0]\nup = [0, 0, 1]\n"),
                HasSubstr("camera.up must have a length, and not lie along"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\npath = [{ at_s = 1, up = [0, 0, 0] }]\n"),
                HasSubstr("camera.path[0].up must have a length"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\nfield_of_view_deg = 0\n"), HasSubstr("between 5 and 120"));
    EXPECT_THAT(
        complaintAbout(kHead + "[camera]\npath = [{ at_s = 1, field_of_view_deg = 121 }]\n"),
        HasSubstr("scene.toml:4: camera.path[0].field_of_view_deg must be a number between 5 and 120"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\npath = [{ eye_m = [1, 2, 3] }]\n"),
                HasSubstr("scene.toml:4: camera.path[0].at_s is missing"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\npath = [{ at_s = 0 }]\n"),
                HasSubstr("camera.path[0].at_s must be above 0"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\npath = [{ at_s = 2 }, { at_s = 2 }]\n"),
                HasSubstr("camera.path[1].at_s must be later"));
    EXPECT_THAT(
        complaintAbout(kHead + "[camera]\npath = [{ at_s = 1, eye_m = [1, 0, 0], target_m = [1, 0, 0] }]\n"),
        HasSubstr("camera.path[0].eye_m must be apart from camera.path[0].target_m"));
    EXPECT_THAT(complaintAbout(kHead + "scale = 2\nheight_m = 2\n"),
                HasSubstr("scale and height_m exclude each other"));
    EXPECT_THAT(complaintAbout(kHead + "scale = 0\n"),
                HasSubstr("scale must be a number between 0.01 and 100"));
    EXPECT_EQ(complaintAbout(kHead + "[camera]\neye_m = [0, 3, 0]\ntarget_m = [0, 0, 0]\n"), "")
        << "straight down";
    for (const char* number : {"1e39", "-1e39", "inf", "nan"}) {
        const std::string vector = std::string("[0, ") + number + ", 1]\n";
        for (const char* key : {"[camera]\neye_m = ", "[camera]\ntarget_m = ", "[light]\nsun_direction = ",
                                "[light]\nsun_colour = ", "[light]\nfloor_colour = ",
                                "[impact]\ndirection = ", "[impact]\ntilt_rad = ", "[[body]]\nposition_m = "})
            EXPECT_THAT(complaintAbout(kHead + key + vector), HasSubstr("three numbers")) << key << vector;
    }
    EXPECT_THAT(complaintAbout(kHead + "[light]\nsun_colour = [-1, 1, 1]\n"), HasSubstr("light.sun_colour"));
}

/// TOML tells a key with a dot in it, in quotes, from a key of a table; whoever writes one means the other.
TEST(SceneFile, RefusesQuotedKeysWithDotsAtEveryLevel) {
    EXPECT_THAT(complaintAbout(kHead + "\"impact.velocity_mps\" = 3\n"),
                testing::AllOf(HasSubstr("scene.toml:3: there is no setting '\"impact.velocity_mps\"'"),
                               HasSubstr("without quotes")));
    EXPECT_EQ(complaintAbout(kHead + "impact.velocity_mps = 3\n"), "");
    EXPECT_THAT(complaintAbout(kHead + "[\"light.x\"]\n"), HasSubstr("'\"light.x\"'"));
    EXPECT_THAT(complaintAbout("\"version.x\" = 1\n" + kHead), HasSubstr("'\"version.x\"'"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\n\"velocity_mps.x\" = 1\n"),
                HasSubstr("'impact.\"velocity_mps.x\"'"));
    EXPECT_THAT(complaintAbout(kHead + "\"ball[0].at_s\" = 1\n"), HasSubstr("'\"ball[0].at_s\"'"));
    EXPECT_THAT(complaintAbout(kHead + "[[ball]]\nat_s = 1\nvelocity_mps = 2\n\"aim_m[0]\" = 1\n"),
                HasSubstr("'ball[0].\"aim_m[0]\"'"));
    EXPECT_THAT(complaintAbout(kHead + "bodies = [{}, {}]\n"), HasSubstr("no setting 'bodies'"));
    EXPECT_THAT(complaintAbout(kHead + "[camra]\n"), HasSubstr("is 'camera' meant?"));
}

TEST(SceneFile, WantsAVersionAndAModel) {
    EXPECT_THAT(complaintAbout("model = \"models/block.obj\"\n"), HasSubstr("version is missing"));
    EXPECT_THAT(complaintAbout("version = 2\nmodel = \"a.obj\"\n"), HasSubstr("version"));
    EXPECT_THAT(complaintAbout("version = 1\n"), HasSubstr("model is missing"));
}

/// A shot of one's own: files beside the scene, and none of ours but what it asks for.
TEST(SceneFile, FilesAreLookedForBesideTheScene) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(dataFolder() / "assets/models/block.obj", folder.path() / "brick.obj");
    folder.write("clay.toml",
                 "version = 1\ndensity_kg_m3 = 1900\n[look]\nexterior_colour = [0.5, 0.2, 0.1]\n");
    const auto file =
        folder.write("shot.toml", "version = 1\nmodel = \"brick.obj\"\nmaterial_preset = \"clay.toml\"\n");
    const Shot shot = loadScene(file.string());
    EXPECT_EQ(shot.model, folder.path() / "brick.obj");
    EXPECT_EQ(shot.scene, "shot");
    EXPECT_EQ(shot.material.name, "clay");
    EXPECT_EQ(shot.material.density, 1900);
    EXPECT_FLOAT_EQ(shot.look.exterior_colour[0], 0.5f);
    Shot again;
    applyMaterial(again, shot.material_name);
    EXPECT_EQ(again.material, shot.material) << "its name holds from anywhere";
}

TEST(SceneFile, FilesThatAreNotThereAreNamedWithLineAndKey) {
    EXPECT_THAT(complaintAbout("version = 1\nmodel = \"none.obj\"\n"),
                testing::AllOf(HasSubstr("scene.toml:2: model is 'none.obj'"), HasSubstr("beside")));
    EXPECT_THAT(complaintAbout(kHead + "material_preset = \"none.toml\"\n"), HasSubstr("none.toml"));
    EXPECT_THAT(complaintAbout(kHead + "[[collider]]\nsize_m = [1, 1, 1]\n"),
                HasSubstr("scene.toml:3: collider[0].shape is missing"));
    const TemporaryFolder folder;
    EXPECT_THROW(loadScene((folder.path() / "none.toml").string()), InputFileError);
    Shot shot;
    EXPECT_THROW(applyMaterial(shot, folder.write("old.toml", "density_kg_m3 = 1900\n").string()),
                 InputFileError)
        << "no version";
}

TEST(SceneFile, ScenesOfOneNameAndModelAreStillTwo) {
    const TemporaryFolder one, other;
    const Shot a = loadScene(one.write("shot.toml", kHead).string());
    const Shot b = loadScene(other.write("shot.toml", kHead).string());
    EXPECT_FALSE(sameSubject(a, b));
    EXPECT_TRUE(sameSubject(a, a));
}

TEST(SceneFile, EveryShippedSceneAndMaterialLoads) {
    const auto scenes = assetNames("scenes");
    EXPECT_THAT(scenes, testing::IsSupersetOf({"block", "bunny"}));
    for (const auto& name : scenes) {
        const Shot shot = loadScene(name);
        EXPECT_NO_THROW(validate(shot)) << name;
        EXPECT_TRUE(std::filesystem::exists(shot.model)) << shot.model;
    }
    const auto materials = assetNames("materials");
    EXPECT_THAT(materials, testing::IsSupersetOf({"ceramic", "concrete", "glass", "stone"}));
    for (const auto& name : materials) {
        Shot shot;
        EXPECT_NO_THROW(applyMaterial(shot, name)) << name;
        EXPECT_EQ(shot.material_name, name);
    }
}

TEST(SceneFile, UnknownNamesListTheKnownOnes) {
    try {
        loadScene("teapot");
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("teapot"), HasSubstr("block, bunny")));
    }
    Shot shot;
    EXPECT_THROW(applyMaterial(shot, "jelly"), UsageError);
}

}  // namespace
}  // namespace demolish
