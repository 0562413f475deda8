// SPDX-License-Identifier: Apache-2.0
// RGBA8 picture in memory, rows from the top down.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace demolish::engine {

struct Image {
    int width = 0, height = 0;    ///< px
    std::vector<uint8_t> pixels;  ///< 4 bytes a pixel, R G B A, sRGB encoded

    Image() = default;
    Image(int width_px, int height_px, std::array<uint8_t, 4> colour = {0, 0, 0, 255});

    uint8_t* at(int x, int y) { return pixels.data() + 4 * (static_cast<size_t>(y) * width + x); }
    const uint8_t* at(int x, int y) const { return pixels.data() + 4 * (static_cast<size_t>(y) * width + x); }
};

}  // namespace demolish::engine
