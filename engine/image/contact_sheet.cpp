// SPDX-License-Identifier: Apache-2.0
// Box filter in exact integer areas, so that a sheet is the same on every machine.
#include "engine/image/contact_sheet.h"

#include <algorithm>

namespace demolish::engine {
namespace {

constexpr std::array<uint8_t, 4> kGapColour{38, 38, 40, 255};

/// Weight of source pixel `s` in destination pixel `d`, in units of 1 / (destination size) source pixels.
int64_t overlap(int64_t s, int64_t d, int64_t source_size, int64_t destination_size) {
    const int64_t begin = std::max(s * destination_size, d * source_size);
    const int64_t end = std::min((s + 1) * destination_size, (d + 1) * source_size);
    return std::max<int64_t>(end - begin, 0);
}

void shrinkPixel(const Image& image, Image& result, int x, int y) {
    const int left = static_cast<int>(int64_t{x} * image.width / result.width);
    const int right = static_cast<int>((int64_t{x + 1} * image.width - 1) / result.width);
    const int top = static_cast<int>(int64_t{y} * image.height / result.height);
    const int bottom = static_cast<int>((int64_t{y + 1} * image.height - 1) / result.height);
    std::array<int64_t, 4> sum{};
    int64_t weights = 0;
    for (int sy = top; sy <= bottom; ++sy) {
        for (int sx = left; sx <= right; ++sx) {
            const int64_t weight =
                overlap(sx, x, image.width, result.width) * overlap(sy, y, image.height, result.height);
            for (int c = 0; c < 4; ++c) sum[c] += weight * image.at(sx, sy)[c];
            weights += weight;
        }
    }
    for (int c = 0; c < 4; ++c) result.at(x, y)[c] = static_cast<uint8_t>((sum[c] + weights / 2) / weights);
}

}  // namespace

Image shrink(const Image& image, int width, int height) {
    Image result(std::clamp(width, 1, image.width), std::clamp(height, 1, image.height));
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) shrinkPixel(image, result, x, y);
    }
    return result;
}

Image contactSheet(std::span<const Image> pictures, int columns, int tile_width, int gap) {
    if (pictures.empty() || pictures[0].width <= 0) return {};
    columns = std::clamp(columns, 1, static_cast<int>(pictures.size()));
    tile_width = std::min(tile_width, pictures[0].width);
    const int tile_height = std::max(1, tile_width * pictures[0].height / pictures[0].width);
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    Image sheet(columns * (tile_width + gap) + gap, rows * (tile_height + gap) + gap, kGapColour);
    for (size_t i = 0; i < pictures.size(); ++i) {
        const Image tile = shrink(pictures[i], tile_width, tile_height);
        const int left = gap + static_cast<int>(i) % columns * (tile_width + gap);
        const int top = gap + static_cast<int>(i) / columns * (tile_height + gap);
        for (int y = 0; y < tile.height; ++y) {
            std::copy_n(tile.at(0, y), size_t{4} * tile.width, sheet.at(left, top + y));
        }
    }
    return sheet;
}

}  // namespace demolish::engine
