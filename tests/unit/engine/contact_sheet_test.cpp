// SPDX-License-Identifier: Apache-2.0
// Contact sheets: every picture in its place, shrunk by exact areas.
#include "engine/image/contact_sheet.h"

#include <gtest/gtest.h>

namespace demolish::engine {
namespace {

TEST(ContactSheet, PicturesStandInRows) {
    const Image pictures[] = {Image(40, 20, {200, 0, 0, 255}), Image(40, 20, {0, 200, 0, 255}),
                              Image(40, 20, {0, 0, 200, 255})};
    const Image sheet = contactSheet(pictures, 2, 20, 3);
    EXPECT_EQ(sheet.width, 2 * 20 + 3 * 3);
    EXPECT_EQ(sheet.height, 2 * 10 + 3 * 3);
    EXPECT_EQ(sheet.at(3, 3)[0], 200);
    EXPECT_EQ(sheet.at(3 + 20 + 3, 3)[1], 200);
    EXPECT_EQ(sheet.at(3, 3 + 10 + 3)[2], 200);
    EXPECT_EQ(sheet.at(0, 0)[0], sheet.at(sheet.width - 1, sheet.height - 1)[0])
        << "gap and empty tile have one colour";
}

TEST(ContactSheet, NoPicturesGiveNoSheet) {
    EXPECT_EQ(contactSheet({}, 3, 100).width, 0);
}

TEST(Shrink, KeepsTheMean) {
    Image image(7, 5);
    double sum = 0;
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        image.pixels[i] = static_cast<uint8_t>(i * 37 % 256);
        sum += image.pixels[i];
    }
    const Image one = shrink(image, 1, 1);
    EXPECT_NEAR(one.pixels[0], sum / 35.0, 0.5);
}

TEST(Shrink, WeighsPixelsByTheirShare) {
    Image image(3, 1);
    image.at(0, 0)[0] = 0;
    image.at(1, 0)[0] = 90;
    image.at(2, 0)[0] = 240;
    const Image two = shrink(image, 2, 1);
    EXPECT_EQ(two.at(0, 0)[0], 30);   // all of 0 and half of 90
    EXPECT_EQ(two.at(1, 0)[0], 190);  // half of 90 and all of 240
}

}  // namespace
}  // namespace demolish::engine
