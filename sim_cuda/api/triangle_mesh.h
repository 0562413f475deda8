// SPDX-License-Identifier: Apache-2.0
// A welded triangle mesh: positions shared, attributes per corner.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim_cuda/api/vectors.h"

namespace demolish {

inline constexpr uint32_t kNoMaterial = 0xffffffffu;
inline constexpr uint32_t kWhite = 0xffffffffu;

struct CornerAttributes {
    Float3 normal;                    ///< unit; the face normal where the file has none
    Float2 uv;                        ///< v upwards in the picture; zero where the file has none
    uint32_t colour = kWhite;         ///< RGBA of 8 bits, red lowest, sRGB; white where the file has none
    uint32_t material = kNoMaterial;  ///< of ModelLooks, the same at all corners of a triangle
    Float2 second_uv = {};            ///< of pictures with ImageUse::uv_set 1; zero where the file has none
};

struct TriangleMesh {
    std::string name;
    std::vector<Double3> positions;                        ///< m, welded
    std::vector<std::array<uint32_t, 3>> triangles;        ///< counter-clockwise seen from outside
    std::vector<std::array<CornerAttributes, 3>> corners;  ///< one per triangle
};

}  // namespace demolish
