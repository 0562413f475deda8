// SPDX-License-Identifier: Apache-2.0
// The ending names the format; what a file says of itself is checked before memory is taken for it.
#include "engine/surroundings/read_picture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <string>

#include "engine/image/png.h"

namespace demolish::engine {
namespace {

/// Twice as wide as high, give or take a crop of some rows.
constexpr double kLeastAspect = 1.9, kMostAspect = 2.1;
constexpr long long kLeastHeight = 4;

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

float cleaned(float value) {
    return value > 0 ? std::min(value, kBrightestTexel) : 0.0f;  // not a number is not above 0
}

}  // namespace

void requirePictureSize(const std::filesystem::path& name, long long width, long long height) {
    const std::string size = name.string() + " is " + std::to_string(width) + "x" + std::to_string(height);
    if (height < kLeastHeight || static_cast<double>(width) < kLeastAspect * static_cast<double>(height) ||
        static_cast<double>(width) > kMostAspect * static_cast<double>(height))
        throw ImageError(size + "; a picture of all directions is twice as wide as high.");
    if (width > kLargestPictureSide || static_cast<size_t>(width * height) > kMostPictureTexels)
        throw ImageError(size + "; at most 8192x4096 can be used: scale it down.");
}

RadiancePicture readRadiancePicture(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored) || !std::ifstream(file))
        throw ImageError(file.string() + " cannot be opened; check that it is there and may be read.");
    const std::string ending = endingOf(file);
    if (ending != ".hdr" && ending != ".exr")
        throw ImageError(file.string() + " is no picture of surroundings; these end in .hdr or .exr.");
    RadiancePicture picture = ending == ".hdr" ? readRadianceHdr(file) : readOpenExr(file);
    for (glm::vec3& texel : picture.texels) texel = {cleaned(texel.x), cleaned(texel.y), cleaned(texel.z)};
    return picture;
}

}  // namespace demolish::engine
