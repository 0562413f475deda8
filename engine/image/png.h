// SPDX-License-Identifier: Apache-2.0
// PNG files: written under a temporary name and renamed, so that a reader never sees half a picture.
#pragma once
#include <filesystem>
#include <stdexcept>

#include "engine/image/image.h"

namespace demolish::engine {

/// File could not be read or written; what() names the file and the reason.
class ImageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// RGB (or RGBA with `alpha`), 8 bit. `compression` 0..9: 3 is quick, 9 small. Throws ImageError, also on a
/// full disk, and leaves no temporary file behind.
void writePng(const std::filesystem::path& file, const Image& image, bool alpha = false, int compression = 3);

/// Any PNG, converted to RGBA8. Throws ImageError.
Image readPng(const std::filesystem::path& file);

}  // namespace demolish::engine
