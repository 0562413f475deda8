// SPDX-License-Identifier: Apache-2.0
// Where pictures lie on the GPU, counted by hand.
#include <gtest/gtest.h>

#include "engine/looks/picture_layout.h"

namespace demolish::engine {
namespace {

BodyLooks looksWith(const std::vector<LookPicture>& pictures) {
    BodyLooks looks;
    looks.pictures = pictures;
    for (uint32_t p = 0; p < pictures.size(); ++p) looks.materials.emplace_back().base = {p};
    return looks;
}

TEST(PictureLayout, SwatchesDoNotGrowToTheSizeOfScans) {
    BodyLooks looks = looksWith({{16, 16, {}}, {4096, 2048, {}}, {512, 8, {}}, {1024, 4096, {}}});
    looks.materials[0].normal = {1};
    const PictureArrays arrays = layOut(looks, 16384);
    EXPECT_EQ(arrays[0].pictures, (std::vector<uint32_t>{0, 2}));
    EXPECT_EQ(arrays[0].width, 512u);
    EXPECT_EQ(arrays[0].height, 16u);
    EXPECT_EQ(arrays[1].pictures, (std::vector<uint32_t>{1, 3}));
    EXPECT_EQ(arrays[1].width, 4096u);
    EXPECT_EQ(arrays[1].height, 4096u);
    EXPECT_TRUE(arrays[2].pictures.empty());
    EXPECT_EQ(arrays[3].pictures, (std::vector<uint32_t>{1})) << "as a colour and as numbers";
}

TEST(PictureLayout, WhatDoesNotFitIsHalvedTheLargestFirst) {
    const BodyLooks looks = looksWith({{4096, 4096, {}}, {256, 256, {}}});
    const PictureArrays arrays = layOut(looks, 16384, uint64_t{8} << 20);
    EXPECT_EQ(arrays[1].width, 1024u);
    EXPECT_EQ(arrays[0].width, 256u);
    EXPECT_LE(bytesOf(arrays), uint64_t{8} << 20);
    EXPECT_EQ(layOut(looks, 2048)[1].width, 2048u) << "no larger than the driver takes";
}

TEST(PictureLayout, OnePictureOfManyMaterialsLiesThereOnce) {
    BodyLooks looks = looksWith({{64, 64, {}}});
    looks.materials.resize(100, looks.materials[0]);
    EXPECT_EQ(layOut(looks, 16384)[0].pictures.size(), 1u);
}

}  // namespace
}  // namespace demolish::engine
