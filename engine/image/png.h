// SPDX-License-Identifier: Apache-2.0
// PNG files: written under a temporary name and renamed, so that a reader never sees half a picture.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

#include "engine/image/image.h"

namespace demolish::engine {

/// File could not be read or written; what() names the file and the reason.
class ImageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

struct PngOptions {
    bool alpha = false;     ///< RGBA, straight as PNG has it; else RGB
    int compression = 3;    ///< 0..9: 3 is quick, 9 small
    std::string note = {};  ///< what made the picture: its text "Description"; "": none
};

/// 8 bit; says of itself that it is sRGB, by the chunks sRGB and cICP. Throws ImageError, also on a full
/// disk, and leaves no temporary file behind.
void writePng(const std::filesystem::path& file, const Image& image, const PngOptions& options = {});

/// Any PNG, converted to RGBA8. Throws ImageError.
Image readPng(const std::filesystem::path& file);

}  // namespace demolish::engine
