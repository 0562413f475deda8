// SPDX-License-Identifier: Apache-2.0
// Which texture array each picture of a body lies in.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/looks/body_looks.h"

namespace demolish::engine {

/// Pictures of one size and kind: small or large, of colours (sRGB) or of numbers.
struct PictureArray {
    uint32_t width = 0, height = 0;  ///< px: of the widest and the highest of them, or halved
    std::vector<uint32_t> pictures;  ///< by layer
};

/// 0 small and 1 large colours, 2 small and 3 large numbers.
inline constexpr uint32_t kPictureArrays = 4, kFirstNumbers = 2;
using PictureArrays = std::array<PictureArray, kPictureArrays>;

inline constexpr uint32_t kSmallPicture = 512;                    ///< px: up to here a picture is small
inline constexpr uint64_t kMostTextureBytes = uint64_t{1} << 30;  ///< on the GPU, with mip maps

/// `largest`: px along a side that the driver takes. Arrays of large pictures are halved until all fit into
/// `most_bytes`.
PictureArrays layOut(const BodyLooks& looks, uint32_t largest, uint64_t most_bytes = kMostTextureBytes);

/// With mip maps.
uint64_t bytesOf(const PictureArrays& arrays);

}  // namespace demolish::engine
