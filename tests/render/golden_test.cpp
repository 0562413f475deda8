// SPDX-License-Identifier: Apache-2.0
// Every test scene against its stored picture, one set per class of renderer.
#include "tests/render/golden_test.h"

#include <algorithm>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

/// One pixel to the right.
Image shifted(const Image& image) {
    Image result = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) std::copy_n(image.at(x - 1, y), 4, result.at(x, y));
    }
    return result;
}

class Golden : public GlTest, public testing::WithParamInterface<std::string> {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (context().info().renderer.find("llvmpipe") == std::string::npos) {
            GTEST_SKIP() << "goldens are stored for llvmpipe, this is " << context().info().renderer;
        }
    }
};

TEST_P(Golden, LooksAsStored) {
    expectLooksAsStored(GetParam(), drawPicture(renderer(), makeScene(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(sceneNames()),
                         [](const auto& param) { return param.param; });

class GoldenRule : public Golden {};

TEST_P(GoldenRule, RefusesTheSamePictureShiftedByAPixel) {
    const Image picture = drawPicture(renderer(), makeScene(GetParam()));
    EXPECT_FALSE(compare(shifted(picture), readPng(goldenFile(GetParam()))).passed);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenRule, testing::Values("cracked_block", "broken_ball"),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace demolish::engine::test
