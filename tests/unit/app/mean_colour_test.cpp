// SPDX-License-Identifier: Apache-2.0
// The one colour of a model: by area, numbers times pictures times colours at the vertices.
#include "app/session/mean_colour.h"

#include <gtest/gtest.h>

namespace demolish {
namespace {

/// Triangles of 0.5 and 1.5 m^2, of materials 0 and 1.
ImportedModel twoTriangles() {
    ImportedModel model;
    model.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 0, 0}};
    model.mesh.triangles = {{0, 1, 2}, {0, 3, 2}};
    model.mesh.corners.resize(2);
    for (uint32_t t = 0; t < 2; ++t)
        for (CornerAttributes& corner : model.mesh.corners[t]) corner.material = t;
    return model;
}

std::shared_ptr<ModelLooks> looks() {
    auto looks = std::make_shared<ModelLooks>();
    looks->materials.resize(2);
    looks->images = {{2, 1, {255, 0, 0, 255, 255, 255, 255, 255}}};
    looks->materials[0].base_map.image = 0;
    looks->materials[1].base_colour[0] = 0.2f;
    looks->materials[1].base_colour[2] = 0;
    return looks;
}

TEST(MeanColour, IsByAreaOfNumbersAndPictures) {
    ImportedModel model = twoTriangles();
    model.looks = looks();
    const auto colour = meanColour(model);
    ASSERT_TRUE(colour);
    EXPECT_NEAR(colour->x, 0.25 * 1 + 0.75 * 0.2, 1e-6);
    EXPECT_NEAR(colour->y, 0.25 * 0.5 + 0.75 * 1, 1e-6);
    EXPECT_NEAR(colour->z, 0.25 * 0.5, 1e-6);
}

TEST(MeanColour, VerticesHaveTheirs) {
    ImportedModel model = twoTriangles();
    model.looks = looks();
    for (auto& corners : model.mesh.corners)
        for (CornerAttributes& corner : corners) corner.colour = 0xff0000ffu;
    const auto colour = meanColour(model);
    ASSERT_TRUE(colour);
    EXPECT_NEAR(colour->x, 0.4, 1e-6);
    EXPECT_EQ(colour->y, 0);
}

TEST(MeanColour, WhatSaysNothingCountsNothing) {
    ImportedModel model = twoTriangles();
    EXPECT_FALSE(meanColour(model));
    auto said = looks();
    said->materials[1].says_nothing = 1;
    model.looks = said;
    EXPECT_NEAR(meanColour(model)->y, 0.5, 1e-6);
    said->materials[0].says_nothing = 1;
    EXPECT_FALSE(meanColour(model));
}

}  // namespace
}  // namespace demolish
