// Every test scene against its stored picture, one set per class of renderer. A failure leaves new, reference
// and difference x 16 side by side in an HTML page.
#include "tests/render/golden_test.h"

#include <cstdlib>
#include <fstream>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

constexpr uintmax_t kLargestGolden = 100'000;  // bytes

std::filesystem::path goldenFile(const std::string& name) {
    return std::filesystem::path(DEMOLISH_SOURCE_DIR) / "tests/render/golden/llvmpipe" / (name + ".png");
}

std::filesystem::path outFolder() {
    const char* folder = std::getenv("DEMOLISH_TEST_OUT");
    return folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(DEMOLISH_RENDER_OUT);
}

void report(const std::string& name, const Image& picture, const Image& reference, const Comparison& result) {
    const std::filesystem::path out = outFolder();
    std::filesystem::create_directories(out);
    writePng(out / (name + "_new.png"), picture);
    writePng(out / (name + "_reference.png"), reference);
    std::string columns = "<img src=\"" + name + "_new.png\"><img src=\"" + name + "_reference.png\">";
    if (result.same_size) {
        writePng(out / (name + "_difference.png"), differencePicture(picture, reference));
        columns += "<img src=\"" + name + "_difference.png\">";
    }
    std::ofstream(out / (name + ".html"))
        << "<!doctype html><title>" << name << "</title><h1>" << name << "</h1><p>wrong pixels "
        << 100.0 * result.wrong_fraction << " %, SSIM " << result.ssim << ", largest difference "
        << result.largest_difference << "</p><p>new, reference, difference x 16</p>" << columns << '\n';
}

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
    const Image picture = drawPicture(renderer(), makeScene(GetParam()));
    if (update_goldens) {
        writePng(goldenFile(GetParam()), picture, false, 9);
        ASSERT_LT(std::filesystem::file_size(goldenFile(GetParam())), kLargestGolden);
        return;
    }
    const Image reference = readPng(goldenFile(GetParam()));
    const Comparison result = compare(picture, reference);
    if (!result.passed) report(GetParam(), picture, reference, result);
    EXPECT_TRUE(result.passed) << "wrong pixels " << 100.0 * result.wrong_fraction << " %, SSIM "
                               << result.ssim << "; see " << outFolder() / (GetParam() + ".html")
                               << "; accept with --update-goldens if the new picture is right";
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
