// SPDX-License-Identifier: Apache-2.0
// The [look] of scenes and materials: what is read and refused, and that none is left over.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/scene_file.h"
#include "tests/unit/app/scene_texts.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::complaintAbout;
using test::kHead;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(SceneLook, ReadsWhatRunsThroughTheSolid) {
    const TemporaryFolder folder;
    const engine::SurfaceLook look =
        loadSceneFile(
            folder.write("a.toml",
                         kHead + "[look]\ntexture = \"bricks\"\ntexture_size_m = 0.3\n"
                                 "texture_colour = [0.1, 0.2, 0.3]\ntexture_outside = 0.5\nrelief = "
                                 "0.08\nrelief_size = 0.4\ncoat_m = "
                                 "0.01\nvariation = 0.2\n"
                                 "refraction_index = 1.4\nabsorption_per_m = [1, 20, 300]\nfrost = 0.7\n"))
            .look;
    EXPECT_EQ(look.texture, engine::SolidTexture::kBricks);
    EXPECT_FLOAT_EQ(look.texture_size, 0.3f);
    EXPECT_FLOAT_EQ(look.texture_colour[2], 0.3f);
    EXPECT_FLOAT_EQ(look.texture_outside, 0.5f);
    EXPECT_FLOAT_EQ(look.relief_height, 0.08f);
    EXPECT_FLOAT_EQ(look.relief_size, 0.4f);
    EXPECT_FLOAT_EQ(look.coat, 0.01f);
    EXPECT_FLOAT_EQ(look.variation, 0.2f);
    EXPECT_TRUE(look.isTransparent());
    EXPECT_FLOAT_EQ(look.absorption[2], 300);
    EXPECT_FLOAT_EQ(look.frost, 0.7f);
    EXPECT_THAT(complaintAbout(kHead + "[look]\ntexture = \"fur\"\n"), HasSubstr("none, veins, layers"));
    EXPECT_THAT(complaintAbout(kHead + "[look]\ntexture_size_m = 0\n"), HasSubstr("texture_size_m"));
    EXPECT_THAT(complaintAbout(kHead + "[look]\nvariation = 1\n"), HasSubstr("look.variation must be"));
    EXPECT_THAT(complaintAbout(kHead + "[look]\nrefraction_index = 0.5\n"), HasSubstr("refraction_index"));
    EXPECT_THAT(complaintAbout(kHead + "[look]\nabsorption_per_m = [1, -2, 3]\n"),
                HasSubstr("absorption_per_m"));
}

TEST(SceneLook, NothingOfOneMaterialStaysInTheNext) {
    Shot first, second;
    applyMaterial(first, "marble");
    applyMaterial(first, "tempered_glass");
    applyMaterial(first, "ceramic");
    applyMaterial(second, "ceramic");
    EXPECT_EQ(first.look, second.look);
    for (const char* name : {"glass", "tempered_glass", "ice"}) {
        applyMaterial(first, name);
        EXPECT_TRUE(first.look.isTransparent()) << name;
    }
}

TEST(SceneLook, BreaksShowTheInsideOfAnotherMaterial) {
    const TemporaryFolder folder;
    const Shot plain = loadSceneFile(folder.write("a.toml", kHead));
    Shot brick = plain;
    applyMaterial(brick, "brick");
    Shot mixed = loadSceneFile(folder.write("b.toml", kHead + "inner_material = \"brick\"\n"));
    EXPECT_EQ(mixed.inner_material, "brick");
    EXPECT_TRUE(mixed.material == plain.material) << "as strong as it was";
    EXPECT_EQ(mixed.look.exterior_colour[0], plain.look.exterior_colour[0]);
    EXPECT_EQ(mixed.look.interior_colour[0], brick.look.interior_colour[0]);
    EXPECT_EQ(mixed.look.texture, engine::SolidTexture::kBricks);
    EXPECT_EQ(mixed.look.texture_outside, 0) << "the pattern is the inside's alone";
    EXPECT_EQ(changeBetween(plain, mixed), Change::kNothing) << "nothing is computed anew";
    applyMaterial(mixed, "concrete");
    EXPECT_EQ(mixed.look.texture, engine::SolidTexture::kBricks) << "another material keeps it";
    applyMaterials(mixed, "ceramic", "");
    EXPECT_EQ(mixed.look, plain.look);

    const std::string bodies = kHead + "[[body]]\n[[body]]\ninner_material = \"marble\"\n";
    const Shot two = loadSceneFile(folder.write("c.toml", bodies));
    EXPECT_EQ(two.bodies[1].material.value().name, "ceramic");
    EXPECT_EQ(two.bodies[1].material.value().inner, "marble");
    EXPECT_EQ(two.bodies[1].material.value().look.texture, engine::SolidTexture::kVeins);
    EXPECT_THAT(complaintAbout(kHead + "inner_material = \"glass\"\n"), HasSubstr("glass is transparent"));
    EXPECT_THAT(complaintAbout(kHead + "material_preset = \"ice\"\ninner_material = \"stone\"\n"),
                HasSubstr("ice is transparent"));
}

}  // namespace
}  // namespace demolish
