// SPDX-License-Identifier: Apache-2.0
// The golden rule: small noise passes; a few wrong pixels, a shift or another size do not.
#include "engine/image/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demolish::engine {
namespace {

Image pattern(int width = 200, int height = 100, int shift = 0) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto v = static_cast<uint8_t>(128 + 100 * std::sin(0.4 * (x + shift)) * std::cos(0.3 * y));
            uint8_t* p = image.at(x, y);
            p[0] = v;
            p[1] = static_cast<uint8_t>(255 - v);
            p[2] = static_cast<uint8_t>(x);
        }
    }
    return image;
}

TEST(Compare, SamePicturePasses) {
    const Comparison result = compare(pattern(), pattern());
    EXPECT_TRUE(result.passed);
    EXPECT_EQ(result.wrong_fraction, 0.0);
    EXPECT_EQ(result.largest_difference, 0);
    EXPECT_NEAR(result.ssim, 1.0, 1e-12);
}

TEST(Compare, NoiseOfFiveLevelsPassesAndSixDoesNot) {
    const auto noisy = [](int level) {
        Image image = pattern();
        for (size_t i = 0; i < image.pixels.size(); i += 4) {
            const int v = image.pixels[i] + (i / 4 % 2 == 0 ? level : -level);
            image.pixels[i] = static_cast<uint8_t>(std::clamp(v, 0, 255));
        }
        return image;
    };
    EXPECT_TRUE(compare(noisy(5), pattern()).passed);
    EXPECT_FALSE(compare(noisy(6), pattern()).passed);
}

TEST(Compare, TwoPixelsInAThousandMayBeWrong) {
    const auto with_wrong_pixels = [](int count) {
        Image image = pattern();
        for (int k = 0; k < count; ++k) image.pixels[static_cast<size_t>(k) * 2003 % 20000 * 4 + 2] ^= 0x20;
        return image;
    };
    const Comparison at_limit = compare(with_wrong_pixels(40), pattern());
    EXPECT_NEAR(at_limit.wrong_fraction, 0.002, 1e-9);
    EXPECT_TRUE(at_limit.passed);
    EXPECT_FALSE(compare(with_wrong_pixels(41), pattern()).passed);
}

TEST(Compare, ShiftFails) {
    EXPECT_FALSE(compare(pattern(200, 100, 1), pattern()).passed);
}

TEST(Compare, StructureIsJudgedApartFromPixels) {
    CompareLimits limits;
    limits.wrong_fraction = 1.0;
    const Comparison result = compare(pattern(200, 100, 4), pattern(), limits);
    EXPECT_LT(result.ssim, 0.9);
    EXPECT_FALSE(result.passed);
}

TEST(Compare, OtherSizeFails) {
    const Comparison result = compare(pattern(200, 100), pattern(100, 200));
    EXPECT_FALSE(result.same_size);
    EXPECT_FALSE(result.passed);
}

TEST(Compare, DifferencePictureShowsWhereAndHowMuch) {
    Image image = pattern();
    image.at(17, 23)[1] = static_cast<uint8_t>(image.at(17, 23)[1] ^ 3);
    const int step = std::abs(image.at(17, 23)[1] - pattern().at(17, 23)[1]);
    const Image difference = differencePicture(image, pattern());
    EXPECT_EQ(difference.at(17, 23)[1], 16 * step);
    EXPECT_EQ(difference.at(17, 23)[0], 0);
    EXPECT_EQ(difference.at(18, 23)[1], 0);
    EXPECT_EQ(difference.at(18, 23)[3], 255);
}

}  // namespace
}  // namespace demolish::engine
