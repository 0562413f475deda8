// SPDX-License-Identifier: Apache-2.0
// Pictures of surroundings as others write them, and what is none.
#include "engine/surroundings/read_picture.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>
#include <limits>

#include "engine/image/png.h"

namespace demolish::engine {
namespace {

class ReadPicture : public testing::Test {
  protected:
    ReadPicture()
        : folder_(std::filesystem::temp_directory_path() / ("demolish_picture_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~ReadPicture() override { std::filesystem::remove_all(folder_); }

    /// Each texel of value (x, y, 1).
    std::filesystem::path writeExr(int width, int height, float first = 0, bool grey = false) const {
        std::vector<std::array<float, 3>> texels;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                texels.push_back(
                    {x == 0 && y == 0 ? first : static_cast<float>(x), static_cast<float>(y), 1});
        Imf::Header header(width, height);
        Imf::FrameBuffer slices;
        const char* const names[] = {"R", "G", "B"};
        for (size_t c = 0; c < (grey ? 1u : 3u); ++c) {
            const char* name = grey ? "Y" : names[c];
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            slices.insert(name,
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&texels[0][c]), sizeof(texels[0]),
                                     sizeof(texels[0]) * static_cast<size_t>(width)));
        }
        const std::filesystem::path file = folder_ / "made.exr";
        Imf::OutputFile out(file.c_str(), header);
        out.setFrameBuffer(slices);
        out.writePixels(height);
        return file;
    }

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }

    static std::string complaint(const std::filesystem::path& file) {
        try {
            readRadiancePicture(file);
        } catch (const ImageError& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
};

/// Texels of 2^(e - 136) times their bytes; not packed.
std::string hdrBytes(int width, int height) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                        std::to_string(width) + "\n";
    for (int i = 0; i < width * height; ++i) {
        bytes += static_cast<char>(64);
        bytes += static_cast<char>(128);
        bytes += static_cast<char>(32);
        bytes += static_cast<char>(i == 0 ? 138 : 128);
    }
    return bytes;
}

TEST_F(ReadPicture, TakesOpenExr) {
    const RadiancePicture picture = readRadiancePicture(writeExr(16, 8));
    ASSERT_EQ(picture.width, 16);
    ASSERT_EQ(picture.height, 8);
    EXPECT_EQ(picture.at(5, 3), glm::vec3(5, 3, 1));
    EXPECT_EQ(readRadiancePicture(writeExr(16, 8, 0, true)).at(5, 3), glm::vec3(5));
}

TEST_F(ReadPicture, TakesRadiance) {
    const RadiancePicture picture = readRadiancePicture(write("made.hdr", hdrBytes(12, 6)));
    ASSERT_EQ(picture.width, 12);
    EXPECT_LT(glm::length(picture.at(3, 3) - glm::vec3(0.25f, 0.5f, 0.125f)), 1e-6f);
    EXPECT_LT(glm::length(picture.at(0, 0) - glm::vec3(256, 512, 128)), 1e-3f);
}

TEST_F(ReadPicture, CleansWhatIsNoLight) {
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), -3.0f})
        EXPECT_EQ(readRadiancePicture(writeExr(16, 8, value)).at(0, 0).x, 0);
    EXPECT_EQ(readRadiancePicture(writeExr(16, 8, std::numeric_limits<float>::infinity())).at(0, 0).x,
              kBrightestTexel);
}

TEST_F(ReadPicture, RefusesWithOneSentenceThatNamesTheFile) {
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    };
    expect(complaint(folder_ / "none.hdr"), "none.hdr cannot be opened");
    expect(complaint(write("made.jpg", "x")), "end in .hdr or .exr");
    expect(complaint(write("made.hdr", "#?RADIANCE\nnothing")), "made.hdr is damaged");
    expect(complaint(write("made.exr", "v/1\x01 and no more")), "made.exr is damaged");
    expect(complaint(writeExr(16, 16)), "is 16x16; a picture of all directions is twice as wide as high");
    expect(complaint(write("made.hdr", hdrBytes(12, 6).substr(0, 150))), "made.hdr is damaged");
    expect(complaint(write("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 40000\n")),
           "40000x20000");
}

}  // namespace
}  // namespace demolish::engine
