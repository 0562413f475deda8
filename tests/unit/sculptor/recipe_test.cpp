// SPDX-License-Identifier: Apache-2.0
// Recipe files: read right, and refused with the name of what is wrong.
#include "assets/models/recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace demolish::sculptor {
namespace {

std::string complaintAbout(const std::string& text) {
    const std::string file = testing::TempDir() + "sculptor_recipe.toml";
    std::ofstream(file) << text;
    try {
        readRecipe(file);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Recipe, RabbitIsReadAsWritten) {
    const Recipe recipe = readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/rabbit.toml");
    EXPECT_DOUBLE_EQ(recipe.unit_m, 0.01);
    const auto& rabbit = std::get<FieldRecipe>(recipe.body);
    ASSERT_EQ(rabbit.parts.size(), 12u);
    EXPECT_DOUBLE_EQ(rabbit.grid, 0.35);
    EXPECT_DOUBLE_EQ(rabbit.parts[3].turn.pitch, -14);
    EXPECT_EQ(rabbit.parts[6].kind, PartKind::kCone);
    EXPECT_TRUE(rabbit.parts[6].mirrored);
    EXPECT_DOUBLE_EQ(rabbit.parts[6].b.y, 33);
    EXPECT_FALSE(rabbit.coat.has_value());
}

TEST(Recipe, WolfHasItsCoatAndItsBlades) {
    const auto wolf = std::get<FieldRecipe>(readRecipe(DEMOLISH_SOURCE_DIR "/assets/models/wolf.toml").body);
    EXPECT_EQ(wolf.parts.size(), 24u + 2 * 17 + 4);
    ASSERT_TRUE(wolf.coat.has_value());
    EXPECT_EQ(wolf.coat->regions.size(), 2u);
    EXPECT_DOUBLE_EQ(wolf.coat->regions[0].below_z, -50);
}

TEST(Recipe, ErrorsNameTheKey) {
    using testing::HasSubstr;
    const std::string head = "kind = \"field\"\nunit_m = 0.01\ncrease_degrees = 180\ngrid = 1\n";
    EXPECT_THAT(complaintAbout("kind = \"field\"\n"), HasSubstr("unit_m"));
    EXPECT_THAT(complaintAbout("unit_m = 1\ncrease_degrees = 0\nkind = \"cake\"\n"), HasSubstr("kind"));
    EXPECT_THAT(complaintAbout(head), HasSubstr("'part'"));
    EXPECT_THAT(complaintAbout(head + "[[part]]\nname = \"ear\"\nkind = \"cone\"\na = [0, 0]\n"),
                testing::AllOf(HasSubstr("'ear'"), HasSubstr("'a' must be three numbers")));
    EXPECT_THAT(
        complaintAbout(head + "[[part]]\nkind = \"ellipsoid\"\ncentre = [0, 0, 0]\nradii = [1, 0, 1]\n"),
        HasSubstr("radii"));
    EXPECT_THAT(complaintAbout("kind = \"column\"\nunit_m = 1\ncrease_degrees = 0\nsectors = 7\n"),
                HasSubstr("sectors"));
    EXPECT_THAT(complaintAbout("= nonsense"), HasSubstr("sculptor_recipe.toml"));
}

}  // namespace
}  // namespace demolish::sculptor
