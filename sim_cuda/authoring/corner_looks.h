// SPDX-License-Identifier: Apache-2.0
// Whether the looks of two triangles go on where they meet, and colours between corners.
#pragma once
#include <algorithm>
#include <array>

#include "sim_cuda/api/triangle_mesh.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {

/// Equal for corners of equal looks, and hardly for others. UVs alone where there is neither material nor
/// colour.
inline uint32_t chartOf(const CornerAttributes& corner) {
    return packHalf2(corner.uv.x, corner.uv.y) ^
           packHalf2(corner.second_uv.x, corner.second_uv.y) * 0xc2b2ae35u ^
           (corner.material + 1) * 0x9e3779b1u ^ (corner.colour ^ kWhite) * 0x85ebca6bu;
}

/// Of RGBA; weights sum to 1.
inline uint32_t blendColours(const std::array<uint32_t, 3>& colours, const std::array<double, 3>& weights) {
    uint32_t blended = 0;
    for (int shift = 0; shift < 32; shift += 8) {
        double sum = 0.5;
        for (size_t k = 0; k < 3; ++k) sum += weights[k] * (colours[k] >> shift & 0xffu);
        blended |= static_cast<uint32_t>(std::clamp(sum, 0.0, 255.0)) << shift;
    }
    return blended;
}

}  // namespace demolish
