// Scene and material files: what is read, and what is refused with file and line.
#include "app/session/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/data_folder.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

const std::string kHead = "version = 1\nmodel = \"models/block.obj\"\n";

/// The sentence of the error that reading this text ends in.
std::string complaintAbout(const std::string& text) {
    const TemporaryFolder folder;
    try {
        loadSceneFile(folder.write("scene.toml", text));
    } catch (const InputFileError& error) {
        return error.what();
    }
    return "";
}

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

TEST(SceneFile, NamesFileAndLineOfAMistake) {
    EXPECT_THAT(complaintAbout(kHead + "height_m = \"tall\"\n"), HasSubstr("scene.toml:3"));
    EXPECT_THAT(complaintAbout(kHead + "\nheight_m = -1\n"),
                HasSubstr("scene.toml:4: height_m must be a number between"));
    EXPECT_THAT(complaintAbout(kHead + "height_m = nan\n"), HasSubstr("scene.toml:3"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\nvelocity = 3\n"),
                HasSubstr("there is no setting 'impact.velocity'"));
    EXPECT_THAT(complaintAbout(kHead + "[impact]\nkind = \"kick\"\n"), HasSubstr("scene.toml:4"));
    EXPECT_THAT(complaintAbout(kHead + "[camera]\neye_m = [1, 2]\n"), HasSubstr("three numbers"));
    EXPECT_THAT(complaintAbout(kHead + "[particles]\nfull = 10.5\n"), HasSubstr("whole number"));
    EXPECT_THAT(complaintAbout("version = 1\nmodel = \n"), HasSubstr("scene.toml:2"));
}

TEST(SceneFile, WantsAVersionAndAModel) {
    EXPECT_THAT(complaintAbout("model = \"models/block.obj\"\n"), HasSubstr("'version' is missing"));
    EXPECT_THAT(complaintAbout("version = 2\nmodel = \"a.obj\"\n"), HasSubstr("version"));
    EXPECT_THAT(complaintAbout("version = 1\n"), HasSubstr("'model' is missing"));
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
