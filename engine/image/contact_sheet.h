// SPDX-License-Identifier: Apache-2.0
// Several pictures on one sheet.
#pragma once
#include <span>

#include "engine/image/image.h"

namespace demolish::engine {

/// Box-filtered reduction to the given size (in px, not larger than the source).
Image shrink(const Image& image, int width, int height);

/// Lays the pictures out row by row in `columns` columns, each fitted into tiles of `tile_width` px (the
/// first picture's aspect), with `gap` px of dark grey between. Empty input gives an empty picture.
Image contactSheet(std::span<const Image> pictures, int columns, int tile_width, int gap = 4);

}  // namespace demolish::engine
