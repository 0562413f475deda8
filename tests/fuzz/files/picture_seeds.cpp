// SPDX-License-Identifier: Apache-2.0
// Small ones: damage is to meet what is read, and not only the middle of long rows.
#include "tests/fuzz/files/picture_seeds.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include <fstream>
#include <iterator>

namespace demolish::fuzz {
namespace {

constexpr int kWidth = 32, kHeight = 16;

std::string hdrHead() {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(kHeight) + " +X " +
           std::to_string(kWidth) + "\n";
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Channels {
    std::vector<float> values = std::vector<float>(static_cast<size_t>(kWidth) * kHeight, 0.7f);
    Imf::FrameBuffer slices;
    Channels() {
        for (const char* name : {"R", "G", "B"})
            slices.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                           sizeof(float) * kWidth));
    }
};

Imf::Header headerOf(Imf::Compression compression, Imf::PixelType type) {
    Imf::Header header(kWidth, kHeight);
    header.compression() = compression;
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(type));
    return header;
}

}  // namespace

std::vector<std::string> hdrSeeds() {
    std::string plain = hdrHead(), coded = hdrHead();
    for (int i = 0; i < kWidth * kHeight; ++i)
        plain += {static_cast<char>(i), 90, 60, static_cast<char>(129)};
    for (int y = 0; y < kHeight; ++y) {
        coded += {2, 2, 0, kWidth};
        for (int channel = 0; channel < 4; ++channel) {
            coded += {static_cast<char>(128 + 20), static_cast<char>(129 - channel), kWidth - 20};
            for (int x = 20; x < kWidth; ++x) coded += static_cast<char>(3 * x + y);
        }
    }
    return {plain, coded};
}

std::vector<std::string> exrSeeds(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "seed.exr";
    std::vector<std::string> seeds;
    Channels floats;
    for (int kind = 0; kind < Imf::NUM_COMPRESSION_METHODS; ++kind) {
        {
            Imf::OutputFile out(file.c_str(), headerOf(static_cast<Imf::Compression>(kind), Imf::FLOAT));
            out.setFrameBuffer(floats.slices);
            out.writePixels(kHeight);
        }
        seeds.push_back(bytesOf(file));
    }
    {
        Imf::Header header = headerOf(Imf::ZIP_COMPRESSION, Imf::FLOAT);
        header.setTileDescription({8, 8, Imf::ONE_LEVEL});
        Imf::TiledOutputFile out(file.c_str(), header);
        out.setFrameBuffer(floats.slices);
        out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
    }
    seeds.push_back(bytesOf(file));
    return seeds;
}

}  // namespace demolish::fuzz
