// SPDX-License-Identifier: Apache-2.0
// Pictures and models with looks, as files: small enough to be known by heart.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace demolish::test {

/// PNG of RGBA texels, upper row first.
std::string pngOf(int width, int height, const std::vector<uint8_t>& texels);
/// Uncompressed TGA of the same.
std::string tgaOf(int width, int height, const std::vector<uint8_t>& texels);

/// 2 x 2 px: red, green above blue, white.
std::vector<uint8_t> fourTexels();

/// A cube of 1 m with a whole picture on every side, its material as `mtl` has it under the name "skin".
std::string cubeObj(const std::string& mtl_file);

/// The same cube as a binary glTF; `material` is the JSON object of its material, `picture` the PNG that it
/// names as texture 0. COLOR_0 is (0.5, 0.25, 1, opacity), linear, with `with_colours`.
std::string cubeGlb(const std::string& material, const std::string& picture, bool with_colours = false,
                    const std::string& textures = R"([{"source":0}])", float opacity = 1);

/// The same as COLLADA, textured by the file `picture`.
std::string cubeDae(const std::string& picture);

}  // namespace demolish::test
