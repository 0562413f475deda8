// SPDX-License-Identifier: Apache-2.0
// A welded triangle mesh: positions shared, attributes per corner.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim_cuda/api/vectors.h"

namespace demolish {

struct CornerAttributes {
    Float3 normal;  ///< unit; the face normal where the file has none
    Float2 uv;      ///< zero where the file has none
};

struct TriangleMesh {
    std::string name;
    std::vector<Double3> positions;                        ///< m, welded
    std::vector<std::array<uint32_t, 3>> triangles;        ///< counter-clockwise seen from outside
    std::vector<std::array<CornerAttributes, 3>> corners;  ///< one per triangle
};

}  // namespace demolish
