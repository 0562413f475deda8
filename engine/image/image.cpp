// SPDX-License-Identifier: Apache-2.0
// A picture of one colour.
#include "engine/image/image.h"

#include <algorithm>

namespace demolish::engine {

Image::Image(int width_px, int height_px, std::array<uint8_t, 4> colour)
    : width(width_px), height(height_px) {
    pixels.resize(size_t{4} * width * height);
    for (size_t i = 0; i < pixels.size(); i += 4) std::copy(colour.begin(), colour.end(), pixels.begin() + i);
}

}  // namespace demolish::engine
