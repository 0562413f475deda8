// SPDX-License-Identifier: Apache-2.0
// PNG files: what goes in comes out; a failed write says so and leaves nothing half done.
#include "engine/image/png.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

namespace demolish::engine {
namespace {

class PngTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) / ("demolish_png_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    size_t filesInFolder() const {
        return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }
    std::filesystem::path folder_;
};

Image noise(int width, int height) {
    Image image(width, height);
    uint32_t state = 1;
    for (uint8_t& value : image.pixels) {
        state = state * 1664525u + 1013904223u;
        value = static_cast<uint8_t>(state >> 24);
    }
    return image;
}

TEST_F(PngTest, RoundTripKeepsEveryByte) {
    const Image image = noise(61, 37);
    writePng(folder_ / "a.png", image, {.alpha = true});
    const Image back = readPng(folder_ / "a.png");
    EXPECT_EQ(back.width, 61);
    EXPECT_EQ(back.height, 37);
    EXPECT_EQ(back.pixels, image.pixels);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(PngTest, WithoutAlphaPicturesComeBackOpaque) {
    const Image image = noise(8, 8);
    writePng(folder_ / "a.png", image);
    const Image back = readPng(folder_ / "a.png");
    for (size_t i = 0; i < back.pixels.size(); ++i)
        EXPECT_EQ(back.pixels[i], i % 4 == 3 ? 255 : image.pixels[i]);
}

TEST_F(PngTest, MissingFolderIsNamed) {
    try {
        writePng(folder_ / "absent" / "a.png", noise(4, 4));
        FAIL() << "written";
    } catch (const ImageError& error) {
        EXPECT_NE(std::string(error.what()).find("absent"), std::string::npos);
    }
}

TEST_F(PngTest, WriteThatDoesNotFitKeepsTheOldPictureAndLeavesNoPart) {
    writePng(folder_ / "a.png", noise(4, 4));
    // A limit on file size stands in for a full disk: the same short write, a different reason.
    rlimit old_limit{};
    getrlimit(RLIMIT_FSIZE, &old_limit);
    const rlimit small{20000, old_limit.rlim_max};
    auto* const old_handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(writePng(folder_ / "a.png", noise(300, 300)), ImageError);
    setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_EQ(filesInFolder(), 1u);
    EXPECT_EQ(readPng(folder_ / "a.png").width, 4);
}

TEST_F(PngTest, UnreadableFilesAreRefused) {
    EXPECT_THROW(readPng(folder_ / "absent.png"), ImageError);
    std::ofstream(folder_ / "text.png") << "not a picture";
    EXPECT_THROW(readPng(folder_ / "text.png"), ImageError);
    EXPECT_THROW(writePng(folder_ / "empty.png", Image()), ImageError);
}

}  // namespace
}  // namespace demolish::engine
