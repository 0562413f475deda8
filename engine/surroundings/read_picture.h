// SPDX-License-Identifier: Apache-2.0
// Pictures of surroundings from files that others wrote: Radiance (.hdr) and OpenEXR (.exr).
#pragma once
#include <filesystem>

#include "engine/surroundings/radiance_picture.h"

namespace demolish::engine {

inline constexpr int kLargestPictureSide = 16384;              // px
inline constexpr size_t kMostPictureTexels = size_t{1} << 25;  // 8192 x 4096
/// Light above this is taken for it: of the sun's disc nothing is lost by that.
inline constexpr float kBrightestTexel = 1e6f;

/// Twice as wide as high. What is not a number, or negative, is dark. Throws ImageError with one sentence.
RadiancePicture readRadiancePicture(const std::filesystem::path& file);

/// Throws ImageError unless a picture of this size can be one of surroundings. `name`: of its file.
void requirePictureSize(const std::filesystem::path& name, long long width, long long height);

RadiancePicture readRadianceHdr(const std::filesystem::path& file);
RadiancePicture readOpenExr(const std::filesystem::path& file);

}  // namespace demolish::engine
